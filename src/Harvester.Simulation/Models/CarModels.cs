using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Cars, off-roaders, pick-ups and vans: a body, a cabin, wheels, mirrors and lamps.</summary>
internal static class CarModels
{
    public static Mesh Build(VehicleRow row, Rgb colour)
    {
        var frame = new ModelFrame(row.Min, row.Max);
        CarProfile profile = CarProfile.Of(row.Shape);
        var builder = new MeshBuilder();
        new CarBody(frame, profile, builder, colour).Add();
        new CarCabin(frame, profile, builder, colour).Add();
        double radius = profile.WheelRadius * frame.Height;
        const double tyre = 0.24;
        VehicleParts.AddAxle(builder, frame, profile.RearAxle, radius, tyre, CarBody.Inset);
        VehicleParts.AddAxle(builder, frame, profile.FrontAxle, radius, tyre, CarBody.Inset);
        VehicleParts.AddLenses(builder, VehicleLampLayout.Of(row));
        AddMirrors(builder, frame, profile, colour);
        if (row.Model.StartsWith("police", StringComparison.Ordinal))
        {
            AddPoliceTrim(builder, frame, profile);
        }
        else if (row.Shape == VehicleShape.Supercar)
        {
            AddSpoiler(builder, frame, profile, colour);
        }

        return builder.Build();
    }

    private static void AddMirrors(MeshBuilder builder, ModelFrame frame, CarProfile profile, Rgb colour)
    {
        double forward = profile.CabinFront - 0.075;
        foreach ((double outer, double inner) in new[] { (0.0, 0.06), (1.0, 0.94) })
        {
            builder.AddBox(
                frame.At(Math.Min(outer, inner), forward, profile.Belt),
                frame.At(Math.Max(outer, inner), forward + 0.026, profile.Belt + 0.09),
                colour.Scaled(0.8),
                Surface.Paint
            );
        }
    }

    private static void AddSpoiler(MeshBuilder builder, ModelFrame frame, CarProfile profile, Rgb colour)
    {
        builder.AddBox(frame.At(0.1, 0.012, profile.Tail + 0.09), frame.At(0.9, 0.07, profile.Tail + 0.115), colour, Surface.Paint);
        builder.AddBox(frame.At(0.18, 0.03, profile.Tail - 0.02), frame.At(0.2, 0.06, profile.Tail + 0.09), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.8, 0.03, profile.Tail - 0.02), frame.At(0.82, 0.06, profile.Tail + 0.09), VehiclePaint.DarkPlastic);
    }

    private static void AddPoliceTrim(MeshBuilder builder, ModelFrame frame, CarProfile profile)
    {
        double middle = (profile.RoofRear + profile.RoofFront) / 2;
        builder.AddBox(frame.At(0.26, middle - 0.02, 0.93), frame.At(0.5, middle + 0.02, 1), new(190, 20, 24), Surface.NightLamp);
        builder.AddBox(frame.At(0.5, middle - 0.02, 0.93), frame.At(0.74, middle + 0.02, 1), new(24, 50, 200), Surface.NightLamp);
        foreach (int side in new[] { -1, 1 })
        {
            double x = frame.X(0.5) + (side * ((frame.Width * (0.5 - CarBody.Inset)) + 0.003));
            builder.AddQuad(
                new(x, frame.Y(0.33), frame.Z(0.3)),
                new(x, frame.Y(0.68), frame.Z(0.3)),
                new(x, frame.Y(0.66), frame.Z(0.44)),
                new(x, frame.Y(0.35), frame.Z(0.44)),
                new(222, 222, 222),
                Surface.Paint
            );
        }
    }
}
