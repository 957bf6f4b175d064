using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Simulation.World;

namespace Harvester.Runs.Tests.Scenarios;

public class RoadsAroundTests
{
    [Fact]
    public void Lanes_around_a_place_are_those_of_the_whole_network()
    {
        RoadNetwork town = TownBuilder.Build(31);
        RoadNetwork part = RoadsAround.Of(town, new Box2D(-250, -250, 250, 250));

        IReadOnlyList<MapLane> expected = Near(town);
        IReadOnlyList<MapLane> lanes = Near(part);

        Assert.True(part.Nodes.Count < town.Nodes.Count);
        Assert.NotEmpty(expected);
        Assert.Equal(expected.Count, lanes.Count);
        Assert.All(expected, lane => Assert.Contains(lanes, other => other.Centre.SequenceEqual(lane.Centre)));
    }

    private static IReadOnlyList<MapLane> Near(RoadNetwork roads) =>
        LaneNetwork.Of(new RoadCurves(roads), new LaneModel(roads)).Index.Near(Vector3D.Zero, 100);
}
