using System.Text;
using Harvester.Exports.Maps;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;

namespace Harvester.Exports.Tests.Maps;

/// <summary>Lanelet2 guesses the direction of borders from their sides; the file must not let it guess wrong in sharp bends.</summary>
public sealed class Lanelet2SidesTests
{
    private const double Straight = 30;

    /// <summary>What is allowed between the edges of the file and the map's, metres: points within a centimetre are left out.</summary>
    private const double MaxDeviation = 0.011;

    [Theory]
    [InlineData(1, 90, 2.5, 2)]
    [InlineData(1, 110, 2.5, 2)]
    [InlineData(1, 110, 4, 2)]
    [InlineData(1, 130, 4, 3)]
    [InlineData(2, 70, 4, 3)]
    [InlineData(2, 90, 4, 2)]
    public void Lanes_of_a_sharp_bend_follow_each_other_as_they_are_read(int lanes, double degrees, double piece, int pieces)
    {
        LaneNetwork map = Bend(lanes, degrees, piece, pieces);
        var read = FileOf(map).Lanelets.ToDictionary(lane => lane.Name, lane => lane.AsRead(), StringComparer.Ordinal);
        ILookup<(long, long), string> starts = read.ToLookup(lane => (lane.Value.Left[0], lane.Value.Right[0]), lane => lane.Key);

        foreach (MapLane lane in map.Lanes)
        {
            (long[] left, long[] right) = read[lane.Id];
            Assert.Equal(lane.Successors.Select(next => next.Id), starts[(left[^1], right[^1])]);
        }
    }

    [Fact]
    public void Edges_before_a_sharp_bend_lie_where_the_map_has_them()
    {
        LaneNetwork map = Bend(1, 110, 4, 2);
        Lanelet2File file = FileOf(map);

        // On the inside of the bend, before and after it.
        foreach (string name in (string[])["7:0-7:1/b0", "7:3-7:4/b0"])
        {
            Lanelet2Lane lane = file.Lanelets.Single(lane => lane.Name == name);
            foreach (
                (long[] written, IReadOnlyList<Vector3D> edge) in new[]
                {
                    (lane.Left, map.Find(name)!.Left),
                    (lane.Right, map.Find(name)!.Right),
                }
            )
            {
                Assert.All(
                    written.Select(file.Place),
                    place => Assert.InRange(TownMap.DistanceFrom(edge, place.X, place.Y), 0, MaxDeviation)
                );
            }
        }
    }

    private static Lanelet2File FileOf(LaneNetwork map)
    {
        using var stream = new MemoryStream();
        Lanelet2Map.Write(map, stream);
        return new Lanelet2File(Encoding.UTF8.GetString(stream.ToArray()));
    }

    /// <summary>A road that bends by an angle in a number of short pieces.</summary>
    private static LaneNetwork Bend(int lanes, double degrees, double piece, int pieces)
    {
        List<Vector3D> places = [new(-Straight, 0, 0), new(0, 0, 0)];
        for (int i = 1; i <= pieces + 1; i++)
        {
            (double sin, double cos) = Math.SinCos(degrees * Math.PI / 180 * i / (pieces + 1));
            places.Add(places[^1] + (new Vector3D(cos, sin, 0) * (i <= pieces ? piece : Straight)));
        }

        var network = new RoadNetwork(
            [.. places.Select((place, number) => new RoadNode(7, number, place, "", RoadNodeFlags.None))],
            [.. Enumerable.Range(1, places.Count - 1).Select(i => new RoadLink(i - 1, i, lanes, lanes, null, RoadLinkFlags.None))]
        );
        return LaneNetwork.Of(new RoadCurves(network), new LaneModel(network));
    }
}
