using System;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Trucks, box vans, buses, tractors and trailers: large bodies on a chassis.</summary>
internal static class HeavyModels
{
    private const double SideInset = 0.02;
    private const double Chassis = 0.2;
    private static readonly Rgb BoxWhite = new(216, 216, 210);

    public static Mesh Build(VehicleRow row, Rgb colour)
    {
        var frame = new ModelFrame(row.Min, row.Max);
        var builder = new MeshBuilder();
        switch (row.Shape)
        {
            case VehicleShape.Bus:
                AddBus(builder, frame, colour);
                break;
            case VehicleShape.Trailer:
                AddTrailer(builder, frame, colour);
                break;
            case VehicleShape.Tractor:
                AddChassis(builder, frame, 0.02, [0.14, 0.3, 0.84]);
                AddCab(builder, frame, 0.12, 1, colour);
                builder.AddCylinder(frame.At(0.1, 0.1, 0.25), frame.At(0.1, 0.1, 0.98), 0.09, 0.09, 10, VehiclePaint.Rim);
                builder.AddCylinder(frame.At(0.9, 0.1, 0.25), frame.At(0.9, 0.1, 0.98), 0.09, 0.09, 10, VehiclePaint.Rim);
                builder.AddBox(frame.At(0, 0, 0.1), frame.At(1, 0.02, 0.3), VehiclePaint.DarkPlastic);
                break;
            case VehicleShape.DumpTruck:
                AddChassis(builder, frame, 0, [0.13, 0.28, 0.82]);
                AddCab(builder, frame, 0.7, 0.96, colour);
                builder.AddFrustum(
                    frame.At(0.05, 0.01, 0.28), frame.At(0.95, 0.66, 1), frame.At(0, 0, 1), frame.At(1, 0.67, 1), colour.Scaled(0.75));
                break;
            case VehicleShape.BoxVan:
                AddChassis(builder, frame, 0, [0.2, 0.8]);
                AddCab(builder, frame, 0.74, 0.97, colour);
                builder.AddBox(frame.At(0, 0, 0.2), frame.At(1, 0.76, 1), colour, Surface.Paint);
                break;
            default:
                AddChassis(builder, frame, 0, [0.2, 0.82]);
                AddCab(builder, frame, 0.68, 0.97, colour);
                builder.AddBox(frame.At(0.002, 0, 0.18), frame.At(0.998, 0.7, 1), row.Model == "firetruk" ? colour
                    : BoxWhite, Surface.Paint);
                AddRoofLamps(builder, frame, row.Model);
                break;
        }

        return builder.Build();
    }

    /// <summary>Adds frame rails, wheels and bumpers from one end of the box to the other.</summary>
    private static void AddChassis(MeshBuilder builder, ModelFrame frame, double rear, double[] axles)
    {
        builder.AddBox(frame.At(0.12, rear, Chassis * 0.5), frame.At(0.88, 0.98, Chassis * 1.3), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(SideInset, rear, Chassis * 0.25), frame.At(1 - SideInset, rear + 0.012, Chassis), VehiclePaint.DarkPlastic);
        foreach (double axle in axles)
        {
            VehicleParts.AddAxle(builder, frame, axle, Math.Min(0.52, frame.Height * 0.16), 0.34, SideInset);
        }
    }

    private static void AddCab(MeshBuilder builder, ModelFrame frame, double rear, double top, Rgb colour)
    {
        const double belt = 0.5;
        double sill = belt * top;
        builder.AddBox(frame.At(SideInset, rear, Chassis * 0.35), frame.At(1 - SideInset, 1, sill), colour, Surface.Paint);
        builder.AddFrustum(
            frame.At(SideInset, rear, sill), frame.At(1 - SideInset, 0.995, top * 0.86), frame.At(SideInset, rear, 1),
                frame.At(1 - SideInset, 0.985, 1), VehiclePaint.Window, Surface.Glass);
        builder.AddFrustum(
            frame.At(SideInset, rear, top * 0.86), frame.At(1 - SideInset, 0.985, top), frame.At(0.05, rear, 1), frame.At(0.95, 0.975, 1),
                colour, Surface.Paint);
        builder.AddBox(frame.At(SideInset / 2, rear, sill),
            frame.At(1 - (SideInset / 2), Math.Max(rear + ((1 - rear) * 0.35), 0.72), top * 0.86), colour, Surface.Paint);
        builder.AddBox(frame.At(0, 0.955, sill), frame.At(0.03, 0.97, sill + 0.12), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.97, 0.955, sill), frame.At(1, 0.97, sill + 0.12), VehiclePaint.DarkPlastic);
        VehicleParts.AddLamps(builder, frame, Chassis, Chassis * 0.9, 0.05);
    }

    private static void AddBus(MeshBuilder builder, ModelFrame frame, Rgb colour)
    {
        const double floor = 0.1;
        builder.AddBox(frame.At(SideInset, 0, floor), frame.At(1 - SideInset, 1, 0.48), colour, Surface.Paint);
        builder.AddBox(frame.At(SideInset + 0.005, 0.01, 0.48), frame.At(0.995 - SideInset, 0.99, 0.82), VehiclePaint.Window,
            Surface.Glass);
        builder.AddFrustum(frame.At(SideInset, 0, 0.82), frame.At(1 - SideInset, 1, 1), frame.At(0.07, 0.02, 1), frame.At(0.93, 0.98, 1),
            colour, Surface.Paint);
        builder.AddBox(frame.At(SideInset - 0.002, 0.02, 0.4), frame.At(1.002 - SideInset, 0.98, 0.43), VehiclePaint.DarkPlastic);
        for (double post = 0.12; post < 0.95; post += 0.135)
        {
            builder.AddBox(frame.At(SideInset, post, 0.48), frame.At(1 - SideInset, post + 0.015, 0.82), colour, Surface.Paint);
        }

        VehicleParts.AddAxle(builder, frame, 0.24, 0.5, 0.3, SideInset / 2);
        VehicleParts.AddAxle(builder, frame, 0.82, 0.5, 0.3, SideInset / 2);
        VehicleParts.AddLamps(builder, frame, 0.2, 0.3, 0.07);
        builder.AddBox(frame.At(0, 0.96, 0.55), frame.At(0.03, 0.975, 0.72), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.97, 0.96, 0.55), frame.At(1, 0.975, 0.72), VehiclePaint.DarkPlastic);
    }

    private static void AddTrailer(MeshBuilder builder, ModelFrame frame, Rgb colour)
    {
        builder.AddBox(frame.At(0.002, 0, 0.28), frame.At(0.998, 1, 1), BoxWhite);
        builder.AddBox(frame.At(0, 0.02, 0.55), frame.At(1, 0.98, 0.72), colour);
        AddChassis(builder, frame, 0, [0.1, 0.2]);
        builder.AddBox(frame.At(0.3, 0.72, 0.02), frame.At(0.36, 0.74, 0.28), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.64, 0.72, 0.02), frame.At(0.7, 0.74, 0.28), VehiclePaint.DarkPlastic);
        VehicleParts.AddLamps(builder, frame, 0.3, 0.2, 0.04);
    }

    private static void AddRoofLamps(MeshBuilder builder, ModelFrame frame, string model)
    {
        if (model == "firetruk")
        {
            builder.AddBox(frame.At(0.2, 0.86, 0.88), frame.At(0.8, 0.9, 0.95), new(200, 20, 24), Surface.NightLamp);
            builder.AddBox(frame.At(0, 0.01, 0.4), frame.At(1, 0.69, 0.46), new(236, 236, 230));
        }
    }
}
