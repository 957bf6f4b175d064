using System;
using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;

namespace Harvester.Datasets.Exports.Kitti;

/// <summary>KITTI's types and levels for what a label says; docs/exports/kitti.md has the table.</summary>
internal static class KittiClasses
{
    /// <summary>Up to here an object counts as fully visible.</summary>
    private const double MostHiddenOfVisible = 0.1;

    /// <summary>Up to here as partly occluded, above as largely.</summary>
    private const double MostHiddenOfPartly = 0.5;

    private const int UnknownOcclusion = 3;

    /// <summary>The type of a class; null for those that KITTI does not label.</summary>
    public static string? TypeOf(ObjectClass kind) => kind switch
    {
        ObjectClass.Car => "Car",
        ObjectClass.Truck => "Truck",
        ObjectClass.Pedestrian => "Pedestrian",
        ObjectClass.Bicycle => "Cyclist",
        ObjectClass.Bus or ObjectClass.Motorcycle or ObjectClass.Trailer or ObjectClass.Other => "Misc",
        ObjectClass.Sign or ObjectClass.TrafficLight => null,
        _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, "The class has no type in KITTI."),
    };

    /// <summary>0 fully visible, 1 partly, 2 largely occluded, 3 unknown.</summary>
    public static int OcclusionOf(ObjectLabel label) => label.OccludedFraction is { } hidden ? LevelOf(hidden) : UnknownOcclusion;

    /// <summary>0, 1 or 2 for nothing to speak of, a part, the larger part.</summary>
    public static int LevelOf(double fraction) => fraction <= MostHiddenOfVisible ? 0 : fraction <= MostHiddenOfPartly ? 1 : 2;
}
