using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Buses: one long body with a row of windows, a tall windscreen, doors on the right and a sign above the windscreen.</summary>
internal static class BusModels
{
    private const double SideInset = 0.02;
    private const double Floor = 0.11;
    private const double Belt = 0.46;
    private const double GlassTop = 0.83;

    public static Mesh Build(VehicleRow row, Rgb colour)
    {
        var frame = new ModelFrame(row.Min, row.Max);
        var builder = new MeshBuilder();
        builder.AddBox(frame.At(SideInset, 0.004, Floor), frame.At(1 - SideInset, 0.992, Belt), colour, Surface.Paint);
        builder.AddFrustum(
            frame.At(SideInset, 0.004, Belt),
            frame.At(1 - SideInset, 0.992, GlassTop),
            frame.At(SideInset + 0.012, 0.008, 0),
            frame.At(0.988 - SideInset, 0.975, 0),
            colour,
            Surface.Paint
        );
        builder.AddFrustum(
            frame.At(SideInset + 0.012, 0.008, GlassTop),
            frame.At(0.988 - SideInset, 0.975, 0.985),
            frame.At(0.06, 0.015, 0),
            frame.At(0.94, 0.965, 0),
            colour,
            Surface.Paint
        );
        builder.AddBox(frame.At(0.3, 0.1, 0.96), frame.At(0.7, 0.4, 1), colour.Scaled(0.9), Surface.Paint);
        builder.AddBox(frame.At(SideInset, 0, Floor * 0.8), frame.At(1 - SideInset, 0.02, 0.24), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(SideInset, 0.98, Floor * 0.8), frame.At(1 - SideInset, 0.998, 0.18), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.4, 0.98, 0.12), frame.At(0.6, 1, 0.17), VehiclePaint.Plate);
        AddWindows(builder, frame);
        builder.AddBox(frame.At(SideInset - 0.004, 0.02, 0.36), frame.At(1.004 - SideInset, 0.97, 0.4), colour.Scaled(0.55));
        VehicleParts.AddPane(
            builder,
            new(0, 1, 0),
            frame.At(0.25, 0.9755, 0.845),
            frame.At(0.75, 0.9755, 0.845),
            frame.At(0.72, 0.961, 0.92),
            frame.At(0.28, 0.961, 0.92),
            new(250, 170, 60),
            Surface.NightLamp
        );
        VehicleParts.AddAxle(builder, frame, 0.24, 0.5, 0.3, SideInset - 0.01);
        VehicleParts.AddAxle(builder, frame, 0.8, 0.5, 0.3, SideInset - 0.01);
        builder.AddBox(frame.At(0, 0.96, 0.55), frame.At(0.035, 0.975, 0.7), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.965, 0.96, 0.55), frame.At(1, 0.975, 0.7), VehiclePaint.DarkPlastic);
        VehicleParts.AddLenses(builder, VehicleLampLayout.Of(row));
        return builder.Build();
    }

    private static void AddWindows(MeshBuilder builder, ModelFrame frame)
    {
        const double low = Belt + 0.01;
        const double high = GlassTop - 0.01;
        VehicleParts.AddPane(
            builder,
            new(0, 1, 0),
            frame.At(SideInset + 0.02, 0.992, low),
            frame.At(0.98 - SideInset, 0.992, low),
            frame.At(0.96 - SideInset, 0.9755, high),
            frame.At(SideInset + 0.04, 0.9755, high),
            VehiclePaint.Window,
            Surface.Glass
        );
        VehicleParts.AddPane(
            builder,
            new(0, -1, 0),
            frame.At(0.15, 0.0045, 0.55),
            frame.At(0.85, 0.0045, 0.55),
            frame.At(0.83, 0.0075, high),
            frame.At(0.17, 0.0075, high),
            VehiclePaint.Window,
            Surface.Glass
        );
        foreach (int side in new[] { -1, 1 })
        {
            double bottom = side < 0 ? SideInset : 1 - SideInset;
            double top = bottom - (side * 0.011);
            bool hasDoors = side > 0;
            for (double from = 0.03; from < (hasDoors ? 0.86 : 0.95); from += 0.117)
            {
                VehicleParts.AddPane(
                    builder,
                    new(side, 0, 0),
                    frame.At(bottom, from, low),
                    frame.At(bottom, from + 0.105, low),
                    frame.At(top, from + 0.105, high),
                    frame.At(top, from, high),
                    VehiclePaint.Window,
                    Surface.Glass
                );
            }

            if (hasDoors)
            {
                VehicleParts.AddPane(
                    builder,
                    new(1, 0, 0),
                    frame.At(bottom, 0.87, Floor + 0.03),
                    frame.At(bottom, 0.96, Floor + 0.03),
                    frame.At(bottom, 0.96, Belt),
                    frame.At(bottom, 0.87, Belt),
                    VehiclePaint.Window,
                    Surface.Glass
                );
                VehicleParts.AddPane(
                    builder,
                    new(1, 0, 0),
                    frame.At(bottom, 0.87, low),
                    frame.At(bottom, 0.96, low),
                    frame.At(top, 0.95, high),
                    frame.At(top, 0.87, high),
                    VehiclePaint.Window,
                    Surface.Glass
                );
            }
        }
    }
}
