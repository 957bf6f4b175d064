using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Lorries: a cab and a body on a chassis.</summary>
internal static class LorryModels
{
    private const double SideInset = 0.03;
    private const double Chassis = 0.18;

    /// <summary>The box ends this fraction of the length before the vehicle does: handles and panes of its doors stand out.</summary>
    private const double BoxRear = 0.0018;
    private static readonly Rgb BoxWhite = new(216, 216, 210);
    private static readonly Rgb Steel = new(168, 172, 176);

    public static Mesh Build(VehicleRow row, Rgb colour)
    {
        var frame = new ModelFrame(row.Min, row.Max);
        var builder = new MeshBuilder();
        switch (row.Shape)
        {
            case VehicleShape.Tractor:
                AddTractor(builder, frame, colour);
                break;
            case VehicleShape.DumpTruck:
                AddChassis(builder, frame, SideInset, [0.13, 0.28, 0.82]);
                AddCab(builder, frame, 0.72, 0.86, colour);
                AddDumper(builder, frame, colour);
                break;
            case VehicleShape.BoxVan:
                AddChassis(builder, frame, SideInset, [0.2, 0.8]);
                AddCab(builder, frame, 0.76, 0.96, colour);
                builder.AddBox(frame.At(0.012, BoxRear, Chassis), frame.At(0.988, 0.87, 1), colour, Surface.Paint);
                AddRearDoors(builder, frame, colour);
                break;
            default:
                bool isFireEngine = row.Model == "firetruk";
                AddChassis(builder, frame, SideInset, [0.2, 0.82]);
                AddCab(builder, frame, 0.7, isFireEngine ? 0.88 : 0.84, colour);
                builder.AddBox(
                    frame.At(0.012, BoxRear, Chassis),
                    frame.At(0.988, 0.69, isFireEngine ? 0.9 : 1),
                    isFireEngine ? colour : BoxWhite,
                    Surface.Paint
                );
                AddRearDoors(builder, frame, isFireEngine ? colour : BoxWhite);
                AddFireEngine(builder, frame, isFireEngine);
                break;
        }

        VehicleParts.AddLenses(builder, VehicleLampLayout.Of(row));
        return builder.Build();
    }

    /// <summary>Adds frame rails, wheels and a rear bumper.</summary>
    private static void AddChassis(MeshBuilder builder, ModelFrame frame, double inset, double[] axles)
    {
        builder.AddBox(frame.At(inset + 0.12, 0.012, Chassis * 0.5), frame.At(0.88 - inset, 0.98, Chassis * 1.2), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(inset, 0.002, Chassis * 0.35), frame.At(1 - inset, 0.016, Chassis), VehiclePaint.DarkPlastic);
        double from = (axles.Length > 2 ? axles[1] : axles[0]) + 0.1;
        builder.AddBox(
            frame.At(inset, from, Chassis * 0.4),
            frame.At(1 - inset, Math.Max(from, axles[^1] - 0.12), Chassis),
            VehiclePaint.DarkPlastic
        );
        foreach (double axle in axles)
        {
            VehicleParts.AddAxle(builder, frame, axle, Math.Min(0.52, frame.Height * 0.165), 0.34, Math.Max(0.004, inset - 0.026));
        }
    }

    /// <summary>Adds a cab that reaches the front end of the box, and mirrors that reach its sides.</summary>
    private static void AddCab(MeshBuilder builder, ModelFrame frame, double rear, double top, Rgb colour)
    {
        double sill = top * 0.5;
        double glassTop = top * 0.88;
        builder.AddBox(frame.At(SideInset, rear, Chassis * 0.45), frame.At(1 - SideInset, 0.99, sill), colour, Surface.Paint);
        builder.AddBox(frame.At(SideInset, 0.97, Chassis * 0.25), frame.At(1 - SideInset, 0.998, Chassis * 1.3), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.2, 0.985, Chassis * 1.4), frame.At(0.8, 0.994, sill * 0.8), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.4, 0.99, Chassis * 0.7), frame.At(0.6, 1, Chassis * 1.0), VehiclePaint.Plate);
        builder.AddFrustum(
            frame.At(SideInset, rear, sill),
            frame.At(1 - SideInset, 0.99, glassTop),
            frame.At(SideInset + 0.02, rear, 0),
            frame.At(0.98 - SideInset, 0.97, 0),
            colour,
            Surface.Paint
        );
        builder.AddFrustum(
            frame.At(SideInset + 0.02, rear, glassTop),
            frame.At(0.98 - SideInset, 0.97, top),
            frame.At(0.08, rear, 0),
            frame.At(0.92, 0.95, 0),
            colour,
            Surface.Paint
        );
        VehicleParts.AddPane(
            builder,
            new(0, 1, 0),
            frame.At(0.07, 0.9895, sill + 0.01),
            frame.At(0.93, 0.9895, sill + 0.01),
            frame.At(0.91, 0.971, glassTop - 0.01),
            frame.At(0.09, 0.971, glassTop - 0.01),
            VehiclePaint.Window,
            Surface.Glass
        );
        double from = Math.Max(rear + ((1 - rear) * 0.3), 0.76);
        foreach (int side in new[] { -1, 1 })
        {
            double low = side < 0 ? SideInset : 1 - SideInset;
            double high = low - (side * 0.02);
            VehicleParts.AddPane(
                builder,
                new(side, 0, 0),
                frame.At(low, from, sill + 0.01),
                frame.At(low, 0.975, sill + 0.01),
                frame.At(high, 0.957, glassTop - 0.01),
                frame.At(high, from, glassTop - 0.01),
                VehiclePaint.Window,
                Surface.Glass
            );
        }

        AddMirrors(builder, frame, 0.955, SideInset + 0.02, sill);
    }

    private static void AddMirrors(MeshBuilder builder, ModelFrame frame, double forward, double reach, double sill)
    {
        builder.AddBox(frame.At(0, forward, sill), frame.At(reach, forward + 0.012, sill + 0.1), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(1 - reach, forward, sill), frame.At(1, forward + 0.012, sill + 0.1), VehiclePaint.DarkPlastic);
    }

    private static void AddRearDoors(MeshBuilder builder, ModelFrame frame, Rgb colour)
    {
        foreach (double left in new[] { 0.04, 0.51 })
        {
            VehicleParts.AddPane(
                builder,
                new(0, -1, 0),
                frame.At(left, 0.0012, Chassis + 0.04),
                frame.At(left + 0.45, 0.0012, Chassis + 0.04),
                frame.At(left + 0.45, 0.0012, 0.85),
                frame.At(left, 0.0012, 0.85),
                colour.Scaled(0.86),
                Surface.Paint
            );
        }

        builder.AddBox(frame.At(0.485, 0, Chassis + 0.2), frame.At(0.515, BoxRear, Chassis + 0.5), VehiclePaint.Rim);
        builder.AddBox(frame.At(0.4, 0.001, Chassis * 0.6), frame.At(0.6, 0.004, Chassis * 0.95), VehiclePaint.Plate);
    }

    private static void AddDumper(MeshBuilder builder, ModelFrame frame, Rgb colour)
    {
        Rgb steel = colour.Scaled(0.75);
        builder.AddFrustum(frame.At(0.08, 0.03, 0.27), frame.At(0.92, 0.66, 0.97), frame.At(0.012, 0, 1), frame.At(0.988, 0.68, 1), steel);
        for (double rib = 0.08; rib < 0.62; rib += 0.14)
        {
            builder.AddFrustum(
                frame.At(0.06, rib, 0.3),
                frame.At(0.94, rib + 0.025, 0.97),
                frame.At(0.004, rib, 1),
                frame.At(0.996, rib + 0.025, 1),
                steel.Scaled(0.8)
            );
        }

        builder.AddBox(frame.At(0.05, 0.62, 0.9), frame.At(0.95, 0.86, 1), steel);
    }

    private static void AddTractor(MeshBuilder builder, ModelFrame frame, Rgb colour)
    {
        // The longer the vehicle, the longer the nose in front of its cab.
        const double inset = 0.07;
        double nose = Math.Clamp((frame.Length - 6) / frame.Length, 0.06, 0.34);
        double cab = 1 - nose;
        double rear = cab - (2.6 / frame.Length);
        AddChassis(builder, frame, inset, [0.12, 0.27, 1 - (1.15 / frame.Length)]);
        builder.AddBox(frame.At(inset, 0, 0.11), frame.At(1 - inset, 0.012, 0.16), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.3, 0.1, 0.21), frame.At(0.7, 0.28, 0.26), VehiclePaint.DarkPlastic);
        builder.AddFrustum(
            frame.At(inset + 0.06, cab - 0.01, 0.16),
            frame.At(0.94 - inset, 0.985, 0.44),
            frame.At(inset + 0.1, cab - 0.01, 0),
            frame.At(0.9 - inset, 0.97, 0),
            colour,
            Surface.Paint
        );
        builder.AddBox(frame.At(0.34, 0.975, 0.17), frame.At(0.66, 0.99, 0.4), Steel);
        builder.AddBox(frame.At(inset, 0.96, 0.09), frame.At(1 - inset, 1, 0.16), Steel);
        builder.AddBox(frame.At(inset, 1 - (1.75 / frame.Length), 0.22), frame.At(1 - inset, 0.985, 0.27), colour, Surface.Paint);
        builder.AddBox(frame.At(inset, rear, 0.15), frame.At(1 - inset, cab, 0.47), colour, Surface.Paint);
        builder.AddFrustum(
            frame.At(inset, rear, 0.47),
            frame.At(1 - inset, cab, 0.7),
            frame.At(inset + 0.02, rear, 0),
            frame.At(0.98 - inset, cab - 0.03, 0),
            colour,
            Surface.Paint
        );
        builder.AddFrustum(
            frame.At(inset + 0.02, rear, 0.7),
            frame.At(0.98 - inset, cab - 0.03, 0.9),
            frame.At(inset + 0.06, rear, 0),
            frame.At(0.94 - inset, rear + ((cab - rear) * 0.35), 0),
            colour,
            Surface.Paint
        );
        VehicleParts.AddPane(
            builder,
            new(0, 1, 0),
            frame.At(inset + 0.03, cab - 0.002, 0.485),
            frame.At(0.97 - inset, cab - 0.002, 0.485),
            frame.At(0.96 - inset, cab - 0.029, 0.69),
            frame.At(inset + 0.04, cab - 0.029, 0.69),
            VehiclePaint.Window,
            Surface.Glass
        );
        foreach (int side in new[] { -1, 1 })
        {
            double low = side < 0 ? inset : 1 - inset;
            double high = low - (side * 0.018);
            VehicleParts.AddPane(
                builder,
                new(side, 0, 0),
                frame.At(low, cab - (1.15 / frame.Length), 0.485),
                frame.At(low, cab - 0.02, 0.485),
                frame.At(high, cab - 0.042, 0.68),
                frame.At(high, cab - (1.15 / frame.Length), 0.68),
                VehiclePaint.Window,
                Surface.Glass
            );
            double stack = side < 0 ? inset - 0.01 : 1.01 - inset;
            builder.AddCylinder(frame.At(stack, rear - 0.02, 0.2), frame.At(stack, rear - 0.02, 0.7), 0.12, 0.12, 8, Steel);
            builder.AddCylinder(frame.At(stack, rear - 0.02, 0.7), frame.At(stack, rear - 0.02, 1), 0.07, 0.07, 8, Steel);
            builder.AddCylinder(frame.At(stack, rear + 0.02, 0.13), frame.At(stack, cab - 0.05, 0.13), 0.17, 0.17, 10, Steel);
        }

        AddMirrors(builder, frame, cab - 0.02, inset + 0.01, 0.5);
    }

    private static void AddFireEngine(MeshBuilder builder, ModelFrame frame, bool isFireEngine)
    {
        if (!isFireEngine)
        {
            return;
        }

        builder.AddBox(frame.At(0.2, 0.86, 0.88), frame.At(0.8, 0.9, 0.95), new(200, 20, 24), Surface.NightLamp);
        builder.AddBox(frame.At(0.006, 0.01, 0.4), frame.At(0.994, 0.685, 0.46), new(236, 236, 230));
        foreach (double rail in new[] { 0.3, 0.42 })
        {
            builder.AddBox(frame.At(rail, 0.0, 0.95), frame.At(rail + 0.02, 0.8, 1), Steel);
        }

        for (double rung = 0.03; rung < 0.8; rung += 0.05)
        {
            builder.AddBox(frame.At(0.3, rung, 0.96), frame.At(0.44, rung + 0.006, 0.985), Steel);
        }
    }
}
