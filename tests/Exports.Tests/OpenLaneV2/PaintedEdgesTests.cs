using Harvester.Exports.Formats.OpenLaneV2;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;

namespace Harvester.Exports.Tests.OpenLaneV2;

/// <summary>
/// Edges of a road to the north with two lanes each way, 5.4 m wide by the rule: edges at 0, 5.4 and 10.8 m on either side. Its paint lies
/// at 3.7 and 7.4 m.
/// </summary>
public sealed class PaintedEdgesTests
{
    private const int None = 0;
    private const int Solid = 1;
    private const int Dashed = 2;

    /// <summary>Axes right, forward, up of a car that faces north at the origin.</summary>
    private static readonly Pose Car = new(default, Axes.FromHeading(0));

    private static readonly LaneNetwork Map = MapOf();

    [Fact]
    public void Measured_paint_marks_the_edge_of_its_number_although_it_lies_aside()
    {
        var painted = new PaintedEdges(
            [
                Line(0, 0, MarkingStyle.DoubleSolid, 0.1),
                Line(1, 3.7, MarkingStyle.Dashed, 0.1),
                Line(2, 7.4, MarkingStyle.Solid, 0.1),
                Line(-2, -3.7, MarkingStyle.Dashed, 0.1),
            ],
            Car
        );

        Assert.Equal((Solid, Dashed), KindsOf(painted, "1:0-1:1/f0"));
        Assert.Equal((Dashed, Solid), KindsOf(painted, "1:0-1:1/f1"));
        Assert.Equal((Solid, Dashed), KindsOf(painted, "1:0-1:1/b0"));
        Assert.Equal((Dashed, None), KindsOf(painted, "1:0-1:1/b1"));
    }

    [Fact]
    public void Measured_paint_marks_no_edge_past_its_end()
    {
        LaneLineView line = Line(1, 3.7, MarkingStyle.Dashed, 0.1);
        var painted = new PaintedEdges([line with { Points = [.. line.Points.Take(12)] }], Car);

        Assert.Equal((None, None), KindsOf(painted, "1:0-1:1/f0"));
    }

    [Fact]
    public void Exact_paint_marks_the_edge_that_it_lies_on()
    {
        var painted = new PaintedEdges([Line(1, 5.3, MarkingStyle.Dashed, null), Line(2, 7.4, MarkingStyle.Solid, null)], Car);

        Assert.Equal((None, Dashed), KindsOf(painted, "1:0-1:1/f0"));
        Assert.Equal((Dashed, None), KindsOf(painted, "1:0-1:1/f1"));
    }

    private static (int Left, int Right) KindsOf(PaintedEdges painted, string id)
    {
        MapLane lane = Map.Find(id)!;
        (int Left, int Right) number = EdgeNumbers.Of(Map.Find("1:0-1:1/f1"))[lane];
        return (
            painted.KindOf(VehicleRange.Points(lane.Left, Car), number.Left),
            painted.KindOf(VehicleRange.Points(lane.Right, Car), number.Right)
        );
    }

    /// <summary>A line along the road, metres to the right of its middle.</summary>
    private static LaneLineView Line(int index, double right, MarkingStyle style, double? sigma) =>
        new(
            index,
            false,
            [.. Enumerable.Range(-20, 41).Select(y => new LaneLinePoint(new Vector3D(right, y * 2, 0), default, default, null))]
        )
        {
            Paint = new MarkingPaint(style, MarkingColour.White, 0.15),
            SigmaMetres = sigma,
        };

    private static LaneNetwork MapOf()
    {
        RoadNode[] nodes = [.. ((double[])[-40, 40]).Select((y, i) => new RoadNode(1, i, new Vector3D(0, y, 0), "", RoadNodeFlags.None))];
        var network = new RoadNetwork(nodes, [new RoadLink(0, 1, 2, 2, null, RoadLinkFlags.None)]);
        return LaneNetwork.Of(new RoadCurves(network), new LaneModel(network));
    }
}
