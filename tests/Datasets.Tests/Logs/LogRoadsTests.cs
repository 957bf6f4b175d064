using Harvester.Datasets.Logs;
using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Tests.Logs;

/// <summary>Roads made of the lanes of a log.</summary>
public sealed class LogRoadsTests
{
    /// <summary>A cubic between points on a circle of 12 m that are 6 m apart leaves it by millimetres; at the ends of the arc, where its
    /// direction is that of the last chord, by centimetres.</summary>
    private const double OnCircle = 0.15;

    [Fact]
    public void Lanes_that_follow_each_other_share_a_node()
    {
        LogRoads roads = LogRoads.Of(LogOf([Straight(1, 0, 20), Straight(2, 20.3, 40)]));

        Assert.Equal(2, roads.Lanes);
        RoadNetwork network = roads.Network;
        Assert.Equal(network.Nodes.Count - 1, network.Links.Count);
        Assert.All(network.Links, link => Assert.Equal((1, 0), (link.LanesForward, link.LanesBackward)));
        Assert.All(network.Links.Zip(network.Links.Skip(1)), pair => Assert.Equal(pair.First.To, pair.Second.From));
    }

    [Fact]
    public void Middles_of_roads_are_those_of_lanes()
    {
        Vector3D[] arc = [.. Enumerable.Range(0, 40).Select(i => new Vector3D(12 * Math.Sin(i * 0.04), 12 * (1 - Math.Cos(i * 0.04)), 5))];
        LogRoads roads = LogRoads.Of(LogOf([new LogFeature(1, LogFeatureKind.Lane, 2, arc)]));

        double[] deviations = roads.Deviations();
        Assert.Equal(arc.Length, deviations.Length);
        Assert.InRange(deviations[^1], 0, OnCircle);
    }

    [Fact]
    public void Bicycle_lanes_and_short_lanes_are_counted_and_left_out()
    {
        LogFeature bicycle = Straight(2, 0, 30) with { Type = 3 };
        LogRoads roads = LogRoads.Of(LogOf([Straight(1, 0, 20), bicycle, Straight(3, 50, 50.5)]));

        Assert.Equal((1, 1, 1), (roads.Lanes, roads.BicycleLanes, roads.ShortLanes));
    }

    private static LogFeature Straight(long id, double from, double to) =>
        new(id, LogFeatureKind.Lane, 2, [new Vector3D(from, 0, 0), new Vector3D((from + to) / 2, 0, 0), new Vector3D(to, 0, 0)]);

    private static MotionLog LogOf(LogFeature[] features) =>
        new(
            "log",
            [0],
            [],
            0,
            features,
            [
                [],
            ]
        );
}
