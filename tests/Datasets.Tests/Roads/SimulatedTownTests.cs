using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Simulation.World;
using Xunit.Abstractions;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>The simulated town, stored as the game would store it: every importer reads it back, and a car is found on it.</summary>
public sealed class SimulatedTownTests(ITestOutputHelper output) : IDisposable
{
    private const int Seed = 3;
    private const double PositionNoise = 0.2;
    private const double HeadingNoiseDegrees = 2;
    private const double Kilometres = 10;

    private readonly string _folder = Directory.CreateTempSubdirectory("town").FullName;
    private readonly RoadNetwork _town = TownBuilder.Build(Seed);

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Importers_read_back_the_town_to_the_step_of_the_stored_grid()
    {
        RoadNetwork stored = Stored(_town);
        foreach ((int area, string text) in YndText.Cells(stored))
        {
            File.WriteAllText(Path.Combine(_folder, $"{area}.ynd.xml"), text);
        }

        RoadNetwork fromYnd = RoadImporter.Import(_folder).Network;
        RoundTripTests.AssertSame(stored, fromYnd);
        foreach (RoadNode node in fromYnd.Nodes)
        {
            Vector3D error = node.Position - _town.Nodes[node.Number].Position;
            Assert.InRange(
                Math.Max(Math.Abs(error.X), Math.Abs(error.Y)),
                0,
                Math.Abs(node.Position.X * node.Position.Y) < PathGrid.HorizontalStep
                    ? PathGrid.HorizontalStep
                    : PathGrid.HorizontalStep / 2
            );
        }

        RoadNetwork flat = new(
            [.. stored.Nodes.Select(node => node with { Area = RoadNode.NoArea, Flags = node.Flags & ~RandomRoads.OfCellsOnly })],
            stored.Links
        );
        RoundTripTests.AssertSame(flat, Import(IplText.Of(flat)));
        RoundTripTests.AssertSame(flat, Import(SceneText.Of(flat)));
        RoadNetwork bare = new(
            [.. stored.Nodes.Select(node => node with { Flags = node.Flags & DumpText.Flags, Speed = null, Density = null })],
            [.. stored.Links.Select(link => link with { MedianWidth = null, Flags = RoadLinkFlags.None })]
        );
        RoundTripTests.AssertSame(bare, Import(DumpText.Of(bare)));
    }

    [Fact]
    public void Match_in_the_imported_town_finds_the_true_link_and_lane()
    {
        // The car drives the town as it was built; the matcher has it with truncated nodes. The text keeps the order of the links.
        RoadNetwork imported = Import(IplText.Of(Stored(_town)));
        var matcher = new RoadMatcher(new RoadCurves(imported), new LaneModel(imported));

        DriveResult result = DriveResult.Of(
            new NetworkDrive(_town, seed: 4),
            matcher,
            Kilometres * 1000,
            PositionNoise,
            HeadingNoiseDegrees
        );

        output.WriteLine(result.ToString());
        Assert.InRange(result.FarFromJunctions.RightFraction, 0.99, 1);
        Assert.InRange(result.Known.RightFraction, 0.99, 1);
    }

    private static RoadNetwork Stored(RoadNetwork town) =>
        new(
            [.. town.Nodes.Select((node, i) => Stored(node, i))],
            [.. town.Links.Select(link => link with { MedianWidth = link.MedianWidth is { } median ? Math.Round(median) : null })]
        );

    private static RoadNode Stored(RoadNode node, int index)
    {
        Vector3D truncated = PathGrid.Truncate(node.Position);
        return node with
        {
            Area = PathGrid.CellOf(truncated),
            Number = index,
            Street = "",
            Position = PathGrid.RemoveBias(truncated),
            Speed = RoadSpeed.Normal,
            Density = 5,
        };
    }

    private RoadNetwork Import(string text)
    {
        string file = Path.Combine(_folder, "roads");
        File.WriteAllText(file, text);
        return RoadImporter.Import(file).Network;
    }
}
