using System.Diagnostics;
using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>The map around a place of the whole game's network.</summary>
[Trait("Category", "Heavy")]
public sealed class RealLaneMapsTests(ITestOutputHelper output)
{
    /// <summary>One lane in this many is tried.</summary>
    private static readonly int Stride = ProofSize.Of(inCi: 487, full: 97);

    [RealWorldFact("nodes.zip")]
    public void Map_around_a_place_is_that_of_the_whole_game()
    {
        var curves = new RoadCurves(RoadImporter.Import(RealWorldFactAttribute.PathOf("nodes.zip")!).Network);
        var lanes = new LaneModel(curves.Network);
        var time = Stopwatch.StartNew();
        var maps = new LaneMaps(curves, lanes);
        output.WriteLine($"prepared in {time.Elapsed.TotalMilliseconds:0} ms");
        time.Restart();
        LaneNetwork whole = maps.Whole();
        output.WriteLine($"whole network in {time.Elapsed.TotalMilliseconds:0} ms");
        Assert.Equal(whole.Lanes.Select(lane => lane.Id), LaneNetwork.Of(curves, lanes).Lanes.Select(lane => lane.Id));

        var durations = new List<double>();
        int compared = 0;
        for (int i = 0; i < whole.Lanes.Count; i += Stride)
        {
            MapLane lane = whole.Lanes[i];
            Vector3D place = lane.Centre[lane.Centre.Count / 2];
            time.Restart();
            LaneNetwork local = maps.Around(place)!;
            durations.Add(time.Elapsed.TotalMilliseconds);
            foreach (MapLane near in whole.Lanes.Skip(Math.Max(0, i - 20)).Take(40).Where(near => IsWithinReach(near, place)))
            {
                MapLane same = local.Find(near.Id)!;
                Assert.NotNull(same);
                Assert.Equal(near.Centre, same.Centre);
                Assert.Equal(near.Successors.Select(next => next.Id), same.Successors.Select(next => next.Id));
                Assert.Equal(near.Predecessors.Select(next => next.Id), same.Predecessors.Select(next => next.Id));
                compared++;
            }
        }

        durations.Sort();
        output.WriteLine(
            $"{compared} lanes around {durations.Count} places are the same; a map takes {durations.Average():0.0} ms on average, "
                + $"{durations[durations.Count / 2]:0.0} in the middle, {durations[^(1 + (durations.Count / 100))]:0.0} at 99 %, "
                + $"{durations[^1]:0.0} at most"
        );
    }

    private static bool IsWithinReach(MapLane lane, Vector3D place) =>
        lane.Centre.Any(point => new Vector2D(point.X - place.X, point.Y - place.Y).Length < LaneMaps.ReachMetres);
}
