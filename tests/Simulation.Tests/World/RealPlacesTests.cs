using System.Globalization;
using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Streets;
using Harvester.Simulation.World;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.World;

/// <summary>The places of data/places.csv on the game's own roads.</summary>
[Trait("Category", "Heavy")]
public sealed class RealPlacesTests(ITestOutputHelper output)
{
    private const double Radius = 400;

    /// <summary>Radius within which lanes are judged, metres: as far as the ego sees well.</summary>
    private const double JudgedRadius = 200;

    /// <summary>
    /// Share of points where a lane may be wrong: the network has lanes that overlap with lanes 1 to 2 m higher.
    /// </summary>
    private const double MaxFaultyShare = 0.003;

    private static readonly Lazy<RoadNetwork> Network = new(() => RoadImporter.Import(RealWorldFactAttribute.PathOf("nodes.zip")!).Network);

    private static IEnumerable<(string Name, Vector3D Centre)> Places =>
        File.ReadLines(Path.Combine(AppContext.BaseDirectory, "places.csv"))
            .Where(line => !line.StartsWith('#') && line != "name,x,y")
            .Select(line => line.Split(','))
            .Select(fields => (fields[0], new Vector3D(NumberOf(fields[1]), NumberOf(fields[2]), 0)));

    [RealWorldFact("nodes.zip")]
    public void Lanes_of_the_places_can_be_driven()
    {
        List<string> bad = [];
        foreach ((string name, Vector3D centre) in ProofSize.Of([.. Places.Where((_, index) => index % 3 == 0)], [.. Places]))
        {
            Site site = Site.OfRoads(1, Network.Value, centre, Radius);
            LaneJudge judge = new(site.Ground);
            LaneFault[] faults =
            [
                .. judge
                    .Faults(
                        site.Lanes.Paths.Where(path =>
                            Horizontal.Distance(path.Line.PositionAt(path.Length / 2), centre) < JudgedRadius && !IsOfAlley(path)
                        )
                    )
                    .Where(fault => fault.Kind is not (LaneFaultKind.Low or LaneFaultKind.Barred) || !IsLow(site, fault.Place)),
            ];
            string summary = $"{name}: {faults.Length} faults at {judge.Judged} points. {string.Join("; ", Worst(faults))}";
            output.WriteLine(summary);
            if (faults.Length > MaxFaultyShare * judge.Judged)
            {
                bad.Add(summary);
            }
        }

        Assert.True(bad.Count == 0, string.Join("\n", bad));
    }

    [RealWorldFact("nodes.zip")]
    public void Buildings_keep_off_roads_and_high_rises_to_the_centre()
    {
        Dictionary<string, int> highRises = [];
        foreach ((string name, Vector3D centre) in Places)
        {
            Site site = Site.OfRoads(1, Network.Value, centre, Radius);
            DrivableStreetsTests.AssertBuildingsAreOffRoads(site);
            highRises[name] = DrivableStreetsTests
                .BuildingsOf(site)
                .Count(building => building.Model.Max.Z > DrivableStreetsTests.HighRise);
        }

        Assert.InRange(highRises["Downtown"], 10, 1000);
        Assert.InRange(highRises["Financial district"], 10, 1000);
        foreach (
            string low in new[] { "Hills and country", "Desert town", "Grapeseed farms", "Chumash coast", "Vinewood Hills", "Mirror Park" }
        )
        {
            Assert.Equal(0, highRises[low]);
        }
    }

    /// <summary>Lanes of car parks lie above each other in storeys that are lower than a lorry.</summary>
    private static bool IsOfAlley(LanePath path) =>
        (path.Road ?? path.Previous[0].Road)!.IsAlley || (path.Road is null && path.Next[0].Road!.IsAlley);

    /// <summary>Whether the network itself has a lane so near above or below that a lorry and a deck do not fit between them.</summary>
    private static bool IsLow(Site site, Vector3D place)
    {
        const double beside = 12;
        const double room = LaneJudge.ClearHeight + 0.8;
        const double sameLevel = 1.5;
        return site.Lanes.Paths.Any(path =>
            path.Line.Points.Any(point =>
                Math.Abs(point.Z - place.Z) is > sameLevel and < room && Horizontal.Distance(point, place) < beside
            )
        );
    }

    private static IEnumerable<LaneFault> Worst(IEnumerable<LaneFault> faults) =>
        faults.GroupBy(fault => fault.Kind).Select(kind => kind.MaxBy(fault => Math.Abs(fault.Metres)));

    private static double NumberOf(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
