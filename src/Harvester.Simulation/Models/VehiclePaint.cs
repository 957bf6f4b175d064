using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Colours of vehicles, by their frequency on the road.</summary>
internal static class VehiclePaint
{
    public static readonly Rgb Rubber = new(22, 22, 24);
    public static readonly Rgb Rim = new(150, 152, 156);
    public static readonly Rgb DarkPlastic = new(38, 38, 42);
    public static readonly Rgb Window = new(26, 32, 38);
    public static readonly Rgb HeadLens = new(206, 208, 204);
    public static readonly Rgb TailLens = new(120, 14, 14);
    public static readonly Rgb IndicatorLens = new(176, 98, 26);
    public static readonly Rgb HeadLight = new(255, 250, 232);
    public static readonly Rgb TailLight = new(176, 14, 12);
    public static readonly Rgb BrakeLight = new(255, 48, 36);
    public static readonly Rgb IndicatorLight = new(255, 168, 24);
    public static readonly Rgb Plate = new(220, 220, 208);

    public static readonly Rgb[] Cars =
    [
        new(214, 216, 218),
        new(30, 31, 34),
        new(128, 132, 138),
        new(150, 24, 28),
        new(34, 62, 118),
        new(182, 184, 180),
        new(72, 78, 86),
        new(22, 74, 58),
        new(196, 150, 52),
        new(108, 66, 42),
    ];

    public static readonly Rgb[] Lorries = [new(224, 224, 220), new(168, 32, 30), new(38, 76, 138), new(210, 166, 40), new(62, 92, 66)];

    public static readonly Rgb[] Cycles = [new(170, 28, 30), new(28, 64, 140), new(36, 36, 40), new(206, 168, 40), new(38, 110, 64)];
}
