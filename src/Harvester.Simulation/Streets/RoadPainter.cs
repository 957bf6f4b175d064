using Harvester.Geometry;
using Harvester.Geometry.Paint;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>Paints the lines along roads, stop lines, pedestrian crossings and arrows.</summary>
internal sealed class RoadPainter(
    RoadPlan plan,
    IReadOnlyList<PaintedRun> runs,
    StreetIndex index,
    Asphalt asphalt,
    GroundMesh mesh,
    PaintWear wear
)
{
    private const double CrossingDepth = 3.2;

    private readonly List<PaintedMark> _marks = [];
    private int _stripes;

    /// <summary>Paints everything.</summary>
    /// <returns>The stop lines, crossings and arrows.</returns>
    public IReadOnlyList<PaintedMark> Paint()
    {
        foreach (PaintedRun run in runs)
        {
            foreach ((double from, double to) in run.Pieces)
            {
                foreach ((double left, double right) in run.Marking.Stripes())
                {
                    Stripe(run.Facets, from, to, left, right, run.Marking.IsYellow ? Palette.Yellow : Palette.White);
                }
            }
        }

        foreach (Junction junction in plan.Junctions.Where(junction => junction.IsCrossing))
        {
            foreach (RoadArm arm in junction.Arms.Where(arm => arm.Road.IsStreet && arm.Road.Length > 2 * arm.Trim))
            {
                PaintStopLine(arm);
                PaintCrossing(arm);
                PaintArrows(arm);
            }
        }

        return _marks;
    }

    private void PaintStopLine(RoadArm arm)
    {
        LaneLayout layout = arm.Road.Layout;
        bool towards = !arm.AtStart;
        int lanes = layout.Lanes(towards);
        if (lanes > 0)
        {
            const double thickness = 0.5;
            double a = layout.LaneCentre(towards, 0);
            double b = layout.LaneCentre(towards, lanes - 1);
            double half = layout.LaneWidth / 2;
            (double from, double to) = Ordered(arm.DistanceAt(arm.Trim), arm.DistanceAt(arm.Trim + thickness));
            (double left, double right) = (Math.Min(a, b) - half + 0.3, Math.Max(a, b) + half - 0.3);
            Stripe(asphalt.Of(arm.Road), from, to, left, right, Palette.White);
            AddMark(MarkKind.StopLine, arm, from, to, left, right);
        }
    }

    private void PaintCrossing(RoadArm arm)
    {
        const double barWidth = 0.5;
        const double barPeriod = 1.1;
        (double from, double to) = Ordered(arm.DistanceAt(arm.Trim - 0.6), arm.DistanceAt(arm.Trim - CrossingDepth));
        RoadFacets facets = asphalt.Of(arm.Road);
        LaneLayout layout = arm.Road.Layout;
        List<double> bars = [];
        for (double offset = layout.LeftEdge + barWidth; offset < layout.RightEdge - barWidth; offset += barPeriod)
        {
            Vector3D middle = arm.Road.Curve.OffsetAt((from + to) / 2, offset);
            if (!index.IsOnAnother(arm.Road, middle, 0))
            {
                Stripe(facets, from, to, offset, offset + barWidth, Palette.White);
                bars.Add(offset);
            }
        }

        if (bars.Count > 0)
        {
            AddMark(MarkKind.Crossing, arm, from, to, bars[0], bars[^1] + barWidth);
        }
    }

    /// <summary>An arrow on each lane that leads to a junction: of several, the leftmost turns left and the rightmost right.</summary>
    private void PaintArrows(RoadArm arm)
    {
        const double behindStopLine = 2.5;
        LaneLayout layout = arm.Road.Layout;
        bool towards = !arm.AtStart;
        int lanes = layout.Lanes(towards);
        double length = (layout.Paint ?? RoadPaint.Usual).ArrowLength;
        double tip = arm.Trim + behindStopLine;
        if (length == 0 || arm.Road.Length < 2 * (tip + length))
        {
            return;
        }

        for (int lane = 0; lane < lanes; lane++)
        {
            MarkKind kind =
                lanes == 1 ? MarkKind.ArrowStraight
                : lane == 0 ? MarkKind.ArrowLeft
                : lane == lanes - 1 ? MarkKind.ArrowRight
                : MarkKind.ArrowStraight;
            double middle = layout.LaneCentre(towards, lane);
            (double left, double right) = (0, 0);
            foreach ((double from, double to, double driversLeft, double driversRight) in ArrowShape.Of(kind, length))
            {
                // Offsets grow to the right of the road's own direction.
                (double a, double b) = towards ? (-driversLeft, driversRight) : (-driversRight, driversLeft);
                (left, right) = (Math.Min(left, a), Math.Max(right, b));
                (double begin, double end) = Ordered(arm.DistanceAt(tip + from), arm.DistanceAt(tip + to));
                Stripe(asphalt.Of(arm.Road), begin, end, middle + a, middle + b, Palette.White);
            }

            (double near, double far) = Ordered(arm.DistanceAt(tip), arm.DistanceAt(tip + length));
            AddMark(kind, arm, near, far, middle + left, middle + right);
        }
    }

    private void AddMark(MarkKind kind, RoadArm arm, double from, double to, double left, double right)
    {
        RoadFacets facets = asphalt.Of(arm.Road);
        Vector3D up = Horizontal.Up * PaintedRun.Height;
        _marks.Add(
            new PaintedMark(
                kind,
                [facets.At(from, left) + up, facets.At(from, right) + up, facets.At(to, right) + up, facets.At(to, left) + up]
            )
        );
    }

    private static (double From, double To) Ordered(double a, double b) => (Math.Min(a, b), Math.Max(a, b));

    private void Stripe(RoadFacets facets, double from, double to, double left, double right, Rgb colour)
    {
        Vector3D up = Horizontal.Up * PaintedRun.Height;
        foreach ((double begin, double end, Rgb worn) in wear.Left(_stripes++, from, to, colour))
        {
            foreach (Vector3D[] face in facets.Cover(begin, end, left, right))
            {
                mesh.AddQuad(face[0] + up, face[1] + up, face[2] + up, face[3] + up, worn, Surface.Marking, SurfaceKind.Marking);
            }
        }
    }
}
