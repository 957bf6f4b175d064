using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Parts common to all vehicles.</summary>
internal static class VehicleParts
{
    private const int WheelSides = 16;
    private const int Spokes = 5;

    /// <summary>Panes lie this far outside the shell on which they are, metres.</summary>
    private const double PaneProud = 0.006;

    /// <summary>Adds two wheels that stand on the box's floor.</summary>
    public static void AddAxle(MeshBuilder builder, ModelFrame frame, double forward, double radius, double breadth, double insetFraction)
    {
        double y = frame.Y(forward);
        AddWheel(builder, new(frame.X(insetFraction), y, frame.Min.Z), 1, radius, breadth);
        AddWheel(builder, new(frame.X(1 - insetFraction), y, frame.Min.Z), -1, radius, breadth);
    }

    /// <summary>Adds a pane with four corners in order, slightly outside a flat face: on the side to which a direction points.</summary>
    public static void AddPane(
        MeshBuilder builder,
        Vector3D outward,
        Vector3D a,
        Vector3D b,
        Vector3D c,
        Vector3D d,
        Rgb colour,
        Surface surface
    )
    {
        Vector3D normal = (b - a).Cross(d - a).Normalized();
        Vector3D proud = normal * (normal.Dot(outward) < 0 ? -PaneProud : PaneProud);
        builder.AddQuad(a + proud, b + proud, c + proud, d + proud, colour, surface);
    }

    /// <summary>Adds the glasses of lamps that are off.</summary>
    public static void AddLenses(MeshBuilder builder, IEnumerable<VehicleLamp> lamps)
    {
        foreach (VehicleLamp lamp in lamps)
        {
            Rgb colour = lamp.Kind switch
            {
                LampKind.Head => VehiclePaint.HeadLens,
                LampKind.Left or LampKind.Right => VehiclePaint.IndicatorLens,
                _ => VehiclePaint.TailLens,
            };
            builder.AddBox(lamp.Min, lamp.Max, colour, Surface.Paint);
        }
    }

    /// <summary>Adds a wheel: tread, side wall, and a rim with spokes. Its lowest corner lies straight below its axle, on the
    /// floor.</summary>
    private static void AddWheel(MeshBuilder builder, Vector3D outerFoot, int inward, double radius, double breadth)
    {
        const double wall = 0.66;
        Vector3D hub = outerFoot + new Vector3D(0, 0, radius);
        Vector3D deep = new(inward * breadth, 0, 0);
        Vector3D sunk = new(inward * 0.025, 0, 0);
        for (int side = 0; side < WheelSides; side++)
        {
            Vector3D a = Around(side);
            Vector3D b = Around(side + 1);
            builder.AddQuad(
                hub + (a * radius),
                hub + (b * radius),
                hub + (b * radius) + deep,
                hub + (a * radius) + deep,
                VehiclePaint.Rubber
            );
            builder.AddQuad(
                hub + (a * radius),
                hub + (b * radius),
                hub + (b * (radius * wall)),
                hub + (a * (radius * wall)),
                VehiclePaint.Rubber
            );
            builder.AddQuad(hub + (a * radius) + deep, hub + (b * radius) + deep, hub + deep, hub + deep, VehiclePaint.Rubber);
            builder.AddTriangle(hub + (a * (radius * wall)), hub + (b * (radius * wall)), hub + sunk, VehiclePaint.Rim, Surface.Paint);
        }

        for (int spoke = 0; spoke < Spokes; spoke++)
        {
            double middle = (spoke + 0.5) * WheelSides / Spokes;
            Vector3D outer = Around(middle) * (radius * wall * 0.9);
            Vector3D aside = (Around(middle + 1.2) - Around(middle - 1.2)) * (radius * wall * 0.25);
            builder.AddTriangle(
                hub + outer + aside - (sunk * 0.05),
                hub + outer - aside - (sunk * 0.05),
                hub + (outer * 0.35) + (sunk * 0.4),
                VehiclePaint.DarkPlastic
            );
        }
    }

    /// <summary>The unit direction from a hub to a corner of its wheel; the first corner is straight down.</summary>
    private static Vector3D Around(double corner)
    {
        double turn = 2 * Math.PI * corner / WheelSides;
        return new(0, Math.Sin(turn), -Math.Cos(turn));
    }
}
