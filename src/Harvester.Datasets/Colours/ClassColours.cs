using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Colours;

/// <summary>
/// One colour for each class, the same in every report and image; distinguishable on light and dark backgrounds, and with most forms of
/// colour blindness.
/// </summary>
public static class ClassColours
{
    /// <summary>The colour of a class as 0xRRGGBB.</summary>
    public static int Of(ObjectClass kind) =>
        kind switch
        {
            ObjectClass.Car => 0x3B9DFF,
            ObjectClass.Truck => 0xFF8F2E,
            ObjectClass.Bus => 0xFFD23F,
            ObjectClass.Motorcycle => 0xC07CFF,
            ObjectClass.Bicycle => 0x2FD3C0,
            ObjectClass.Trailer => 0xC79A6B,
            ObjectClass.Pedestrian => 0xFF4F79,
            ObjectClass.Rider => 0xFF8FC7,
            ObjectClass.Sign => 0x7EE05A,
            ObjectClass.TrafficLight => 0xEDFF6B,
            _ => 0xB4BCC4,
        };
}
