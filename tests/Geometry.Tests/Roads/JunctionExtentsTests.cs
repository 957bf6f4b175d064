using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Roads;

public sealed class JunctionExtentsTests
{
    private const double Lane = RoadGeometry.LaneWidth;
    private const double Corner = 1.5;

    [Fact]
    public void Junction_extends_to_the_corners_of_its_roads()
    {
        // A road of two lanes each way goes north, one of one lane each way crosses it.
        JunctionExtents extents = Of(
            [(0, 0), (0, -60), (0, 60), (60, 0), (-60, 0)],
            [new(1, 0, 2, 2, null, RoadLinkFlags.None), new(0, 2, 2, 2, null, RoadLinkFlags.None), Two(0, 3), Two(4, 0)]
        );

        Assert.Equal((0, Lane + Corner), Rounded(extents.Of(0)));
        Assert.Equal((Lane + Corner, 0), Rounded(extents.Of(1)));
        Assert.Equal(((2 * Lane) + Corner, 0), Rounded(extents.Of(2)));
        Assert.Equal((0, (2 * Lane) + Corner), Rounded(extents.Of(3)));
        Assert.True(extents.Contains(2, 12.2));
        Assert.False(extents.Contains(2, 12.4));
    }

    [Fact]
    public void Roads_that_meet_at_a_slant_have_a_more_distant_corner()
    {
        // At 60 degrees the edges of two roads that are w wide on either side cross at (w + w cos 60) / sin 60.
        JunctionExtents extents = Of([(0, 0), (0, -60), (0, 60), (52, 30)], [Two(1, 0), Two(0, 2), Two(0, 3)]);

        double sharp = Lane * (1 + Math.Cos(Angles.ToRadians(60))) / Math.Sin(Angles.ToRadians(60));
        double blunt = Lane * (1 + Math.Cos(Angles.ToRadians(120))) / Math.Sin(Angles.ToRadians(120));
        Assert.Equal(sharp + Corner, extents.Of(1).FromStart, 0.05);
        Assert.Equal(blunt + Corner, extents.Of(0).FromEnd, 0.05);
        Assert.Equal(sharp + Corner, extents.Of(2).FromStart, 0.05);
    }

    [Fact]
    public void Junction_extends_across_links_shorter_than_itself()
    {
        JunctionExtents extents = Of([(0, 0), (0, -60), (0, 60), (4, 0), (60, 0)], [Two(1, 0), Two(0, 2), Two(0, 3), Two(3, 4)]);

        Assert.True(extents.Contains(2, 2));
        Assert.Equal(Lane + Corner - 4, extents.Of(3).FromStart, 6);
    }

    [Fact]
    public void Road_that_others_merge_with_keeps_its_lanes()
    {
        // A slip road joins a motorway at 15 degrees: the motorway continues, the slip road's lane ends before.
        JunctionExtents extents = Of(
            [(0, 0), (0, -60), (0, 60), (-16, -60)],
            [
                new(1, 0, 2, 0, null, RoadLinkFlags.None),
                new(0, 2, 2, 0, null, RoadLinkFlags.None),
                new(3, 0, 1, 0, null, RoadLinkFlags.None),
            ]
        );

        Assert.Equal((0, 0), extents.Of(0));
        Assert.Equal((0, 0), extents.Of(1));
        Assert.InRange(extents.Of(2).FromEnd, 20, 40);
    }

    [Fact]
    public void Link_between_two_carriageways_is_a_junction_unlike_them()
    {
        JunctionExtents extents = Of(
            [(0, -50), (0, 0), (0, 50), (14, 50), (14, 10), (14, -50)],
            [One(0, 1), One(1, 2), One(3, 4), One(4, 5), Two(1, 4)]
        );

        for (int link = 0; link < 4; link++)
        {
            Assert.Equal((0, 0), extents.Of(link));
        }

        Assert.True(extents.Contains(4, 1));
        Assert.True(extents.Contains(4, 16));
    }

    [Fact]
    public void Bend_and_dead_end_are_not_junctions()
    {
        JunctionExtents extents = Of([(0, 0), (0, 60), (60, 60)], [Two(0, 1), Two(1, 2)]);

        Assert.Equal((0, 0), extents.Of(0));
        Assert.Equal((0, 0), extents.Of(1));
    }

    private static JunctionExtents Of((double X, double Y)[] nodes, RoadLink[] links)
    {
        var network = new RoadNetwork(
            [.. nodes.Select((node, i) => new RoadNode(0, i, new Vector3D(node.X, node.Y, 0), string.Empty, RoadNodeFlags.None))],
            links
        );
        return new JunctionExtents(new RoadCurves(network), new LaneModel(network));
    }

    private static RoadLink Two(int from, int to) => new(from, to, 1, 1, null, RoadLinkFlags.None);

    private static RoadLink One(int from, int to) => new(from, to, 1, 0, null, RoadLinkFlags.None);

    private static (double, double) Rounded((double FromStart, double FromEnd) extents) =>
        (Math.Round(extents.FromStart, 6), Math.Round(extents.FromEnd, 6));
}
