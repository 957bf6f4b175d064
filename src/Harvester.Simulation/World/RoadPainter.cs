using System;
using System.Linq;
using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.World;

/// <summary>Paints the lines along roads, stop lines and crossings for people. There are no lines where carriageways overlap.</summary>
internal sealed class RoadPainter(RoadPlan plan, RoadIndex index, GroundMesh mesh)
{
    /// <summary>Paint lies this far above the asphalt, metres: enough to be drawn, too little to be seen as height.</summary>
    private const double PaintHeight = 0.01;
    private const double LineWidth = 0.15;
    private const double DashLength = 3;
    private const double DashPeriod = 9;
    private const double PieceLength = 3;
    private const double CrossingDepth = 3.2;

    public void Paint()
    {
        foreach (Road road in plan.Roads.Where(road => !road.IsInner && !road.IsUnpaved))
        {
            RoadRibbon ribbon = new(road, mesh);
            foreach (Marking marking in road.Layout.Markings())
            {
                PaintLine(road, ribbon, marking);
            }
        }

        foreach (Junction junction in plan.Junctions.Where(junction => junction.IsCrossing))
        {
            foreach (RoadArm arm in junction.Arms.Where(arm => arm.Road.IsStreet && arm.Road.Length > 2 * arm.Trim))
            {
                PaintStopLine(arm);
                PaintCrossing(arm);
            }
        }
    }

    private void PaintLine(Road road, RoadRibbon ribbon, Marking marking)
    {
        double end = road.Length - road.EndTrim;
        double period = marking.IsDashed ? DashPeriod : PieceLength;
        double length = marking.IsDashed ? DashLength : PieceLength;
        for (double from = road.StartTrim; from < end; from += period)
        {
            double to = Math.Min(from + length, end);
            if (!index.IsOnAnother(road, road.Curve.OffsetAt((from + to) / 2, marking.Offset), 0))
            {
                Stripe(ribbon, from, to, marking.Offset - (LineWidth / 2), marking.Offset + (LineWidth / 2), marking.IsYellow ? Palette.Yellow : Palette.White);
            }
        }
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
            Stripe(new RoadRibbon(arm.Road, mesh), from, to, Math.Min(a, b) - half + 0.3, Math.Max(a, b) + half - 0.3, Palette.White);
        }
    }

    private void PaintCrossing(RoadArm arm)
    {
        const double barWidth = 0.5;
        const double barPeriod = 1.1;
        (double from, double to) = Ordered(arm.DistanceAt(arm.Trim - 0.6), arm.DistanceAt(arm.Trim - CrossingDepth));
        RoadRibbon ribbon = new(arm.Road, mesh);
        LaneLayout layout = arm.Road.Layout;
        for (double offset = layout.LeftEdge + barWidth; offset < layout.RightEdge - barWidth; offset += barPeriod)
        {
            Vector3D middle = arm.Road.Curve.OffsetAt((from + to) / 2, offset);
            if (!index.IsOnAnother(arm.Road, middle, 0))
            {
                Stripe(ribbon, from, to, offset, offset + barWidth, Palette.White);
            }
        }
    }

    private static (double From, double To) Ordered(double a, double b) => (Math.Min(a, b), Math.Max(a, b));

    private static void Stripe(RoadRibbon ribbon, double from, double to, double left, double right, Rgb colour) =>
        ribbon.LayBetween(from, to, new Rail(left, PaintHeight), new Rail(right, PaintHeight), colour, Surface.Matte);
}
