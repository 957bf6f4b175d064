using System;
using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>
/// Motorcycles and bicycles. The rider is a separate entity in the game, and the model's box is that of the machine alone. The simulated
/// rider sits low enough to stay within it, so that the machine is not an empty frame.
/// </summary>
internal static class CycleModels
{
    private static readonly Rgb Leather = new(40, 38, 40);
    private static readonly Rgb Steel = new(120, 124, 130);

    public static Mesh Build(VehicleRow row, Rgb colour)
    {
        var frame = new ModelFrame(row.Min, row.Max);
        var builder = new MeshBuilder();
        bool isMotorcycle = row.Shape == VehicleShape.Motorcycle;
        double radius = Math.Min(frame.Length * (isMotorcycle ? 0.18 : 0.22), frame.Height * 0.42);
        double breadth = isMotorcycle ? 0.16 : 0.045;
        AddWheel(builder, frame, frame.Min.Y, radius, breadth, 1);
        AddWheel(builder, frame, frame.Max.Y, radius, breadth, -1);
        if (isMotorcycle)
        {
            AddMotorcycleBody(builder, frame, colour);
        }
        else
        {
            AddBicycleFrame(builder, frame, radius, colour);
        }

        return builder.Build();
    }

    /// <summary>A wheel that touches the box's floor and one of its ends.</summary>
    private static void AddWheel(MeshBuilder builder, ModelFrame frame, double end, double radius, double breadth, int inward)
    {
        const int sides = 20;
        var hub = new Vector3D(frame.X(0.5), end + (inward * radius), frame.Min.Z + radius);
        Vector3D half = new(breadth / 2, 0, 0);
        builder.AddCylinder(hub - half, hub + half, radius, radius, sides, VehiclePaint.Rubber);
        Vector3D rim = half * 1.1;
        builder.AddCylinder(hub - rim, hub + rim, radius * 0.66, radius * 0.66, 12, Steel);
    }

    private static void AddMotorcycleBody(MeshBuilder builder, ModelFrame frame, Rgb colour)
    {
        builder.AddFrustum(frame.At(0.14, 0.2, 0.2), frame.At(0.86, 0.7, 0.55), frame.At(0.12, 0.14, 0), frame.At(0.88, 0.76, 0), Steel);
        builder.AddFrustum(frame.At(0.26, 0.45, 0.55), frame.At(0.74, 0.8, 0.82), frame.At(0.34, 0.5, 0), frame.At(0.66, 0.72, 0), colour,
            Surface.Paint);
        builder.AddFrustum(frame.At(0.2, 0.08, 0.5), frame.At(0.8, 0.5, 0.78), frame.At(0.22, 0.03, 0), frame.At(0.78, 0.48, 0), Leather);
        builder.AddFrustum(frame.At(0.14, 0.7, 0.42), frame.At(0.86, 0.94, 0.86), frame.At(0.1, 0.7, 0), frame.At(0.9, 0.88, 0), colour,
            Surface.Paint);
        builder.AddFrustum(frame.At(0.14, 0.7, 0.86), frame.At(0.86, 0.86, 1), frame.At(0.24, 0.68, 0), frame.At(0.76, 0.76, 0),
            VehiclePaint.Window, Surface.Glass);
        builder.AddBox(frame.At(0, 0.66, 0.76), frame.At(1, 0.71, 0.84), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0, 0.67, 0.84), frame.At(0.16, 0.69, 0.95), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.84, 0.67, 0.84), frame.At(1, 0.69, 0.95), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.4, 0.88, 0.6), frame.At(0.6, 0.95, 0.74), VehiclePaint.HeadLamp, Surface.NightLamp);
        builder.AddBox(frame.At(0.4, 0.03, 0.56), frame.At(0.6, 0.05, 0.64), VehiclePaint.TailLamp, Surface.NightLamp);
        AddTube(builder, frame.At(0.4, 0.82, 0.2), frame.At(0.4, 0.7, 0.82), 0.03, Steel);
        AddTube(builder, frame.At(0.6, 0.82, 0.2), frame.At(0.6, 0.7, 0.82), 0.03, Steel);
        AddTube(builder, frame.At(0.78, 0.05, 0.36), frame.At(0.74, 0.5, 0.24), 0.05, Steel);
    }

    private static void AddBicycleFrame(MeshBuilder builder, ModelFrame frame, double radius, Rgb colour)
    {
        const double tube = 0.022;
        var rear = new Vector3D(frame.X(0.5), frame.Min.Y + radius, frame.Min.Z + radius);
        var front = new Vector3D(frame.X(0.5), frame.Max.Y - radius, frame.Min.Z + radius);
        Vector3D crank = frame.At(0.5, 0.46, 0.3);
        Vector3D seat = frame.At(0.5, 0.36, 0.78);
        Vector3D head = frame.At(0.5, 0.72, 0.8);
        AddTube(builder, rear, crank, tube, colour);
        AddTube(builder, rear, seat, tube, colour);
        AddTube(builder, crank, seat, tube, colour);
        AddTube(builder, crank, head, tube * 1.3, colour);
        AddTube(builder, seat, head, tube, colour);
        AddTube(builder, front, head, tube * 1.2, Steel);
        builder.AddBox(frame.At(0.36, 0.26, 0.8), frame.At(0.64, 0.46, 0.87), Leather);
        builder.AddBox(frame.At(0, 0.7, 0.94), frame.At(1, 0.735, 1), VehiclePaint.DarkPlastic);
        AddTube(builder, head, frame.At(0.5, 0.715, 0.96), tube, Steel);
        builder.AddBox(frame.At(0.3, 0.42, 0.28), frame.At(0.7, 0.5, 0.32), Steel);
    }

    private static void AddTube(MeshBuilder builder, Vector3D from, Vector3D to, double radius, Rgb colour) =>
        builder.AddCylinder(from, to, radius, radius, 8, colour, Surface.Paint);
}
