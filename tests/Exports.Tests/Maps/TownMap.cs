using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Simulation.World;

namespace Harvester.Exports.Tests.Maps;

/// <summary>The map of a generated town, with a light, signs, a crossing and a painted line that its lanes and junctions suggest.</summary>
internal static class TownMap
{
    private const double BesideLane = 1.5;

    public static LaneNetwork Of(int seed)
    {
        RoadNetwork network = TownBuilder.Build(seed);
        var curves = new RoadCurves(network);
        var lanes = new LaneModel(network);
        var bare = LaneNetwork.Of(curves, lanes);

        // The rightmost lane of each road into the junctions with the most roads, one for lights, one for a sign, one for signs all round.
        MapLane[][] approaches =
        [
            .. bare
                .Lanes.Where(lane => lane.RightNeighbour is null && lane.Successors is [{ Junction: not null }, ..])
                .GroupBy(lane => lane.Successors[0].Junction!.Value)
                .OrderByDescending(group => group.Count())
                .ThenBy(group => group.Key)
                .Take(3)
                .Select(group => group.ToArray()),
        ];
        MapLane painted = bare.Lanes.First(lane => lane.RightNeighbour is not null);
        Vector3D corner = approaches[0][0].Centre[^1];
        return LaneNetwork.Of(
            curves,
            lanes,
            new MapContent
            {
                Props =
                [
                    .. approaches[0].Select(lane => PropAt(lane, MapSignalKind.Light)),
                    PropAt(approaches[1][0], MapSignalKind.StopSign),
                    .. approaches[2].Select(lane => PropAt(lane, MapSignalKind.StopSign)),
                ],
                KnownLines =
                [
                    new PaintedLine(
                        new MarkingPaint(MarkingStyle.Dashed, MarkingColour.White, 0.15),
                        [.. painted.Right.Select(point => new LinePoint(point, true))]
                    ),
                ],
                KnownMarks =
                [
                    new PaintedMark(
                        MarkKind.Crossing,
                        [corner, corner + new Vector3D(3, 0, 0), corner + new Vector3D(3, 8, 0), corner + new Vector3D(0, 8, 0)]
                    ),
                ],
            }
        );
    }

    /// <summary>Distance of a point from a line on the ground, metres.</summary>
    public static double DistanceFrom(IReadOnlyList<Vector3D> line, double x, double y)
    {
        double best = double.PositiveInfinity;
        for (int i = 1; i < line.Count; i++)
        {
            (double dx, double dy) = (line[i].X - line[i - 1].X, line[i].Y - line[i - 1].Y);
            (double px, double py) = (x - line[i - 1].X, y - line[i - 1].Y);
            double t = Math.Clamp(((dx * px) + (dy * py)) / Math.Max((dx * dx) + (dy * dy), double.Epsilon), 0, 1);
            best = Math.Min(best, Math.Sqrt(Math.Pow(px - (t * dx), 2) + Math.Pow(py - (t * dy), 2)));
        }

        return best;
    }

    private static MapProp PropAt(MapLane lane, MapSignalKind kind)
    {
        Vector3D end = lane.Right[^1];
        Vector2D ahead = lane.EndDirection;
        return new MapProp(
            kind,
            "",
            new Vector3D(end.X + (ahead.Y * BesideLane), end.Y - (ahead.X * BesideLane), end.Z),
            new Vector3D(-ahead.X, -ahead.Y, 0)
        );
    }
}
