using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Roads;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Tables in which every boundary of a direction is painted as a solid line: yellow at left edges, white elsewhere.</summary>
internal static class SolidPaint
{
    public const double SigmaMetres = 0.02;

    public static void Write(RoadNetwork roads, string path, double laneWidth)
    {
        var curves = new RoadCurves(roads);
        using var text = new StreamWriter(path);
        IEnumerable<LinkPaint> links = Enumerable.Range(0, roads.Links.Count).Select(link => Painted(curves, link, laneWidth));
        PaintCsvWriter.Write(new PaintTable(roads, links), text);
    }

    /// <summary>Other roads: the same ones, seven metres east.</summary>
    public static RoadNetwork Moved(RoadNetwork roads) =>
        new([.. roads.Nodes.Select(node => node with { Position = node.Position + new Vector3D(7, 0, 0) })], roads.Links);

    private static LinkPaint Painted(RoadCurves curves, int link, double laneWidth)
    {
        RoadLink road = curves.Network.Links[link];
        double length = curves.Of(link).Length;
        double left = road.IsOneWay ? -road.LanesForward * laneWidth / 2 : (road.MedianWidth ?? 0) / 2;
        LinePaint Line(double offset, MarkingColour colour) =>
            new(0, length, offset, offset, new MarkingPaint(MarkingStyle.Solid, colour, 0.15)) { SigmaMetres = SigmaMetres, Images = 3 };
        List<LinePaint> lines = [];
        if (road.LanesForward > 0)
        {
            lines.Add(Line(left, MarkingColour.Yellow));
            lines.Add(Line(left + (road.LanesForward * laneWidth), MarkingColour.White));
        }

        if (road.LanesBackward > 0)
        {
            double edge = road.LanesForward > 0 ? left : -road.LanesBackward * laneWidth / 2;
            lines.Add(Line(-edge - (road.LanesBackward * laneWidth), MarkingColour.White));
            if (edge != 0 || road.LanesForward == 0)
            {
                lines.Add(Line(-edge, MarkingColour.Yellow));
            }
        }

        return new LinkPaint(link, 0, length, lines);
    }
}
