using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>
/// Motorcycles and bicycles without their riders, who are entities of their own: the model's box is that of the machine alone.
/// </summary>
internal static class CycleModels
{
    private static readonly Rgb Leather = new(40, 38, 40);
    private static readonly Rgb Steel = new(150, 154, 160);

    public static Mesh Build(VehicleRow row, Rgb colour)
    {
        var frame = new ModelFrame(row.Min, row.Max);
        var builder = new MeshBuilder();
        bool isBicycle = row.Shape == VehicleShape.Bicycle;
        double radius = Math.Min(frame.Length * (isBicycle ? 0.225 : 0.175), frame.Height * 0.42);
        double breadth = isBicycle ? 0.045 : 0.15;
        AddWheel(builder, frame, frame.Min.Y, radius, breadth, 1);
        AddWheel(builder, frame, frame.Max.Y, radius, breadth, -1);
        switch (row.Shape)
        {
            case VehicleShape.Bicycle:
                AddBicycle(builder, frame, radius, colour);
                break;
            case VehicleShape.Chopper:
                AddChopper(builder, frame, radius, colour);
                break;
            default:
                AddSportsMachine(builder, frame, radius, colour);
                break;
        }

        VehicleParts.AddLenses(builder, VehicleLampLayout.Of(row));
        return builder.Build();
    }

    /// <summary>A wheel that touches the box's floor and one of its ends: a tyre around spokes, open between them.</summary>
    private static void AddWheel(MeshBuilder builder, ModelFrame frame, double end, double radius, double breadth, int inward)
    {
        const int sides = 20;
        const int spokes = 8;
        double inner = radius - Math.Min(0.07, breadth * 0.8);
        var hub = new Vector3D(frame.X(0.5), end + (inward * radius), frame.Min.Z + radius);
        Vector3D half = new(breadth / 2, 0, 0);
        Vector3D Around(double corner) => new(0, Math.Sin(2 * Math.PI * corner / sides), -Math.Cos(2 * Math.PI * corner / sides));
        for (int side = 0; side < sides; side++)
        {
            Vector3D a = Around(side);
            Vector3D b = Around(side + 1);
            builder.AddQuad(
                hub + (a * radius) - half,
                hub + (b * radius) - half,
                hub + (b * radius) + half,
                hub + (a * radius) + half,
                VehiclePaint.Rubber
            );
            foreach (Vector3D face in new[] { half, -half })
            {
                builder.AddQuad(
                    hub + (a * radius) + face,
                    hub + (b * radius) + face,
                    hub + (b * inner) + face,
                    hub + (a * inner) + face,
                    VehiclePaint.Rubber
                );
            }
        }

        for (int spoke = 0; spoke < spokes; spoke++)
        {
            double middle = spoke * (double)sides / spokes;
            Vector3D along = Around(middle) * inner;
            Vector3D across = Around(middle + (sides / 4.0)) * (breadth * 0.12);
            builder.AddTriangle(hub + along + across, hub + along - across, hub, Steel);
        }

        builder.AddCylinder(hub - (half * 1.1), hub + (half * 1.1), radius * 0.22, radius * 0.22, 8, Steel);
    }

    private static void AddSportsMachine(MeshBuilder builder, ModelFrame frame, double radius, Rgb colour)
    {
        builder.AddFrustum(frame.At(0.2, 0.3, 0.16), frame.At(0.8, 0.66, 0.55), frame.At(0.16, 0.3, 0), frame.At(0.84, 0.72, 0), Steel);
        builder.AddFrustum(
            frame.At(0.24, 0.42, 0.55),
            frame.At(0.76, 0.76, 0.82),
            frame.At(0.34, 0.46, 0),
            frame.At(0.66, 0.68, 0),
            colour,
            Surface.Paint
        );
        builder.AddFrustum(frame.At(0.3, 0.2, 0.6), frame.At(0.7, 0.46, 0.74), frame.At(0.3, 0.2, 0), frame.At(0.7, 0.46, 0), Leather);
        builder.AddFrustum(
            frame.At(0.3, 0.02, 0.64),
            frame.At(0.7, 0.26, 0.84),
            frame.At(0.36, 0.0, 0),
            frame.At(0.64, 0.22, 0),
            colour,
            Surface.Paint
        );
        builder.AddFrustum(
            frame.At(0.18, 0.66, 0.3),
            frame.At(0.82, 0.93, 0.8),
            frame.At(0.14, 0.66, 0),
            frame.At(0.86, 0.88, 0),
            colour,
            Surface.Paint
        );
        builder.AddFrustum(
            frame.At(0.2, 0.68, 0.8),
            frame.At(0.8, 0.87, 1),
            frame.At(0.28, 0.66, 0),
            frame.At(0.72, 0.74, 0),
            VehiclePaint.Window,
            Surface.Glass
        );
        AddFork(builder, frame, radius, 0.74, 0.82, 0.42);
        AddHandlebar(builder, frame, 0.67, 0.8);
        AddSwingArm(builder, frame, radius);
    }

    private static void AddChopper(MeshBuilder builder, ModelFrame frame, double radius, Rgb colour)
    {
        builder.AddFrustum(frame.At(0.22, 0.34, 0.14), frame.At(0.78, 0.6, 0.5), frame.At(0.28, 0.36, 0), frame.At(0.72, 0.58, 0), Steel);
        builder.AddFrustum(
            frame.At(0.34, 0.42, 0.54),
            frame.At(0.66, 0.66, 0.72),
            frame.At(0.42, 0.44, 0),
            frame.At(0.58, 0.62, 0),
            colour,
            Surface.Paint
        );
        builder.AddFrustum(frame.At(0.28, 0.16, 0.48), frame.At(0.72, 0.42, 0.58), frame.At(0.3, 0.14, 0), frame.At(0.7, 0.4, 0), Leather);
        builder.AddFrustum(
            frame.At(0.36, 0.02, 0.4),
            frame.At(0.64, 0.24, 0.56),
            frame.At(0.4, 0.06, 0),
            frame.At(0.6, 0.2, 0),
            colour,
            Surface.Paint
        );
        builder.AddBox(frame.At(0.38, 0.84, 0.44), frame.At(0.62, 0.97, 0.48), colour, Surface.Paint);
        builder.AddFrustum(frame.At(0.4, 0.1, 0.5), frame.At(0.6, 0.14, 1), frame.At(0.38, 0.06, 0), frame.At(0.62, 0.09, 0), Leather);
        AddFork(builder, frame, radius, 0.66, 0.84, 0.44);
        AddHandlebar(builder, frame, 0.66, 0.93);
        AddTube(builder, frame.At(0.5, 0.68, 0.84), frame.At(0.5, 0.67, 0.95), 0.025, Steel);
        AddSwingArm(builder, frame, radius);
    }

    private static void AddFork(MeshBuilder builder, ModelFrame frame, double radius, double topForward, double topHeight, double aside)
    {
        var hub = new Vector3D(0, frame.Max.Y - radius, frame.Min.Z + radius);
        foreach (double right in new[] { aside, 1 - aside })
        {
            AddTube(builder, hub with { X = frame.X(right) }, frame.At(right, topForward, topHeight), 0.028, Steel);
        }
    }

    /// <summary>A handlebar that reaches the sides of the box, with mirrors or grips that reach its top.</summary>
    private static void AddHandlebar(MeshBuilder builder, ModelFrame frame, double forward, double height)
    {
        builder.AddBox(frame.At(0, forward, height - 0.025), frame.At(1, forward + 0.03, height + 0.02), VehiclePaint.DarkPlastic);
        foreach (double left in new[] { 0.02, 0.84 })
        {
            builder.AddBox(frame.At(left, forward, height), frame.At(left + 0.14, forward + 0.015, 1), VehiclePaint.DarkPlastic);
        }
    }

    private static void AddSwingArm(MeshBuilder builder, ModelFrame frame, double radius)
    {
        var hub = new Vector3D(0, frame.Min.Y + radius, frame.Min.Z + radius);
        foreach (double right in new[] { 0.38, 0.62 })
        {
            AddTube(builder, hub with { X = frame.X(right) }, frame.At(right, 0.42, 0.36), 0.028, Steel);
        }

        AddTube(builder, frame.At(0.72, 0.1, 0.3), frame.At(0.7, 0.5, 0.2), 0.045, Steel);
    }

    private static void AddBicycle(MeshBuilder builder, ModelFrame frame, double radius, Rgb colour)
    {
        const double tube = 0.022;
        var rear = new Vector3D(frame.X(0.5), frame.Min.Y + radius, frame.Min.Z + radius);
        var front = new Vector3D(frame.X(0.5), frame.Max.Y - radius, frame.Min.Z + radius);
        Vector3D crank = frame.At(0.5, 0.46, 0.3);
        Vector3D seat = frame.At(0.5, 0.36, 0.78);
        Vector3D head = frame.At(0.5, 0.7, 0.8);
        AddTube(builder, rear, crank, tube, colour);
        AddTube(builder, rear, seat, tube, colour);
        AddTube(builder, crank, seat, tube, colour);
        AddTube(builder, crank, head, tube * 1.3, colour);
        AddTube(builder, seat, head, tube, colour);
        AddTube(builder, front, head, tube * 1.2, Steel);
        builder.AddBox(frame.At(0.36, 0.26, 0.8), frame.At(0.64, 0.46, 0.87), Leather);
        builder.AddBox(frame.At(0, 0.69, 0.94), frame.At(1, 0.725, 1), VehiclePaint.DarkPlastic);
        AddTube(builder, head, frame.At(0.5, 0.705, 0.96), tube, Steel);
        builder.AddCylinder(crank - new Vector3D(0.03, 0, 0), crank + new Vector3D(0.03, 0, 0), 0.09, 0.09, 10, Steel);
    }

    private static void AddTube(MeshBuilder builder, Vector3D from, Vector3D to, double radius, Rgb colour) =>
        builder.AddCylinder(from, to, radius, radius, 6, colour, Surface.Paint);
}
