using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Tests.World;

public class CornerTests
{
    [Fact]
    public void Build_sharp_corner_leads_the_lanes_around_it()
    {
        // An arc of 15 / (2 tan 45°) = 7.5 m is too sharp for lanes that reach 5.4 m to the inner side.
        RoadPlan plan = Plan(new(0, -60, 0), new(0, -15, 0), new(0, 0, 0), new(15, 0, 0), new(60, 0, 0));

        Junction corner = Assert.Single(plan.Junctions, junction => junction.IsCorner);
        Assert.Equal(2, plan.Roads.Count);

        // Half of the carriageway is 5.4 m, with the strip to park 7.8 m: so far do the roads reach over each other, and 3.5 m are left as
        // room.
        Assert.All(corner.Arms, arm => Assert.Equal(11.3, arm.Trim, 9));
        var index = new StreetIndex(plan.Roads);
        var heights = new AsphaltHeights(index, new RoadLevels(plan.Roads, index));
        Assert.All(new LaneGraph(plan, heights).Paths, AssertNeverTurnsBack);
    }

    [Fact]
    public void Build_wide_bend_stays_one_road()
    {
        // 20 degrees at nodes 30 m apart: an arc of 30 / (2 tan 10°) = 85 m.
        RoadPlan plan = Plan(new(0, -60, 0), new(0, -30, 0), new(0, 0, 0), new(10.26, 28.19, 0), new(20.52, 56.38, 0));

        Assert.Single(plan.Roads);
        Assert.DoesNotContain(plan.Junctions, junction => junction.IsCorner);
    }

    private static RoadPlan Plan(params Vector3D[] places)
    {
        RoadNode[] nodes = [.. places.Select((place, number) => new RoadNode(0, number, place, string.Empty, RoadNodeFlags.None))];
        RoadLink[] links = [.. Enumerable.Range(1, places.Length - 1).Select(to => new RoadLink(to - 1, to, 1, 1, 0, RoadLinkFlags.None))];
        return RoadPlan.Build(new RoadNetwork(nodes, links), Vector3D.Zero, 1000);
    }

    /// <summary>A lane that is folded on the inner side of a bend runs against its own direction there.</summary>
    private static void AssertNeverTurnsBack(LanePath path)
    {
        for (int i = 1; i < path.Line.Points.Count; i++)
        {
            Vector3D step = path.Line.Points[i] - path.Line.Points[i - 1];
            Assert.True(
                step.Dot(path.Line.TangentAt(path.Length * (i - 0.5) / (path.Line.Points.Count - 1))) > 0,
                $"Path {path.Index} runs back at {path.Line.Points[i]}."
            );
        }
    }
}
