using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Trailers of lorries: a box, a tank, or logs between stakes, on a chassis with two axles and landing legs.</summary>
internal static class TrailerModels
{
    private const double Deck = 0.28;
    private const double WheelRadius = 0.5;

    /// <summary>The box ends this fraction of the length before the trailer does: handles and panes of its doors stand out.</summary>
    private const double BoxRear = 0.001;
    private static readonly Rgb BoxWhite = new(216, 216, 210);
    private static readonly Rgb Tank = new(190, 194, 198);
    private static readonly Rgb Bark = new(104, 80, 56);
    private static readonly Rgb Cut = new(188, 152, 104);

    public static Mesh Build(VehicleRow row, Rgb colour)
    {
        var frame = new ModelFrame(row.Min, row.Max);
        var builder = new MeshBuilder();
        builder.AddBox(frame.At(0.3, 0.01, Deck - 0.07), frame.At(0.7, 0.99, Deck), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.02, 0.002, 0.16), frame.At(0.98, 0.008, 0.225), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.4, 0.0006, 0.165), frame.At(0.6, 0.003, 0.215), VehiclePaint.Plate);
        VehicleParts.AddAxle(builder, frame, 0.1, WheelRadius, 0.4, 0.02);
        VehicleParts.AddAxle(builder, frame, 0.2, WheelRadius, 0.4, 0.02);
        foreach (double leg in new[] { 0.3, 0.64 })
        {
            builder.AddBox(frame.At(leg, 0.72, 0.02), frame.At(leg + 0.06, 0.74, Deck), VehiclePaint.DarkPlastic);
        }

        switch (row.Shape)
        {
            case VehicleShape.Tanker:
                AddTank(builder, frame, colour);
                break;
            case VehicleShape.LogTrailer:
                AddLogs(builder, frame);
                break;
            default:
                AddBoxBody(builder, frame, colour);
                break;
        }

        VehicleParts.AddLenses(builder, VehicleLampLayout.Of(row));
        return builder.Build();
    }

    private static void AddBoxBody(MeshBuilder builder, ModelFrame frame, Rgb colour)
    {
        builder.AddBox(frame.At(0.004, BoxRear, Deck), frame.At(0.996, 1, 1), BoxWhite);
        builder.AddBox(frame.At(0.485, 0, 0.4), frame.At(0.515, BoxRear, 0.8), VehiclePaint.Rim);
        builder.AddBox(frame.At(0, 0.02, 0.55), frame.At(1, 0.98, 0.72), colour);
        foreach (double left in new[] { 0.04, 0.51 })
        {
            VehicleParts.AddPane(
                builder,
                new(0, -1, 0),
                frame.At(left, 0.0006, Deck + 0.03),
                frame.At(left + 0.45, 0.0006, Deck + 0.03),
                frame.At(left + 0.45, 0.0006, 0.97),
                frame.At(left, 0.0006, 0.97),
                BoxWhite.Scaled(0.85),
                Surface.Matte
            );
        }
    }

    private static void AddTank(MeshBuilder builder, ModelFrame frame, Rgb colour)
    {
        const int sides = 20;
        const double middle = 0.62;
        double radius = frame.Height * (0.97 - middle);
        builder.AddCylinder(frame.At(0.5, 0.03, middle), frame.At(0.5, 0.97, middle), radius, radius, sides, Tank, Surface.Paint);
        builder.AddCylinder(frame.At(0.5, 0, middle), frame.At(0.5, 0.03, middle), radius * 0.75, radius, sides, Tank, Surface.Paint);
        builder.AddCylinder(frame.At(0.5, 0.97, middle), frame.At(0.5, 1, middle), radius, radius * 0.75, sides, Tank, Surface.Paint);
        builder.AddCylinder(frame.At(0.5, 0.3, middle), frame.At(0.5, 0.34, middle), radius * 1.012, radius * 1.012, sides, colour);
        builder.AddCylinder(frame.At(0.5, 0.66, middle), frame.At(0.5, 0.7, middle), radius * 1.012, radius * 1.012, sides, colour);
        builder.AddBox(frame.At(0.4, 0.15, 0.95), frame.At(0.6, 0.85, 1), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0, 0.3, 0.3), frame.At(0.12, 0.65, 0.36), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.88, 0.3, 0.3), frame.At(1, 0.65, 0.36), VehiclePaint.DarkPlastic);
    }

    private static void AddLogs(MeshBuilder builder, ModelFrame frame)
    {
        builder.AddBox(frame.At(0.01, 0, Deck), frame.At(0.99, 1, Deck + 0.025), VehiclePaint.DarkPlastic);
        foreach (double stake in new[] { 0.06, 0.35, 0.64, 0.93 })
        {
            builder.AddBox(frame.At(0, stake, Deck), frame.At(0.03, stake + 0.01, 1), VehiclePaint.DarkPlastic);
            builder.AddBox(frame.At(0.97, stake, Deck), frame.At(1, stake + 0.01, 1), VehiclePaint.DarkPlastic);
        }

        const double radius = 0.26;
        double first = frame.Z(Deck + 0.025) + radius;
        for (int row = 0; row < 4; row++)
        {
            int count = row % 2 == 0 ? 5 : 4;
            for (int log = 0; log < count; log++)
            {
                double x = frame.X(0.5) + ((log - ((count - 1) / 2.0)) * 0.51);
                double z = first + (row * 0.45);
                double shift = ((row * 5) + log) % 3 * 0.012;
                builder.AddCylinder(
                    new(x, frame.Y(0.02 + shift), z),
                    new(x, frame.Y(0.95 + shift), z),
                    radius,
                    radius * 0.9,
                    8,
                    ((row + log) & 1) == 0 ? Bark : Bark.Scaled(0.85)
                );
                builder.AddCylinder(
                    new(x, frame.Y(0.0195 + shift), z),
                    new(x, frame.Y(0.0205 + shift), z),
                    radius * 0.86,
                    radius * 0.86,
                    8,
                    Cut
                );
            }
        }
    }
}
