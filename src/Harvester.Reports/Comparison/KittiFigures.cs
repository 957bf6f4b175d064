namespace Harvester.Reports.Comparison;

/// <summary>
/// KITTI's object detection training set: the lines of its 7,481 label files (Geiger, Lenz, Urtasun 2012) by type, without DontCare.
/// </summary>
public static class KittiFigures
{
    /// <summary>Labels by type, in the order of KITTI's development kit.</summary>
    public static IReadOnlyList<(string Type, int Labels)> Training { get; } =
    [
        ("Car", 28_742),
        ("Van", 2_914),
        ("Truck", 1_094),
        ("Pedestrian", 4_487),
        ("Person_sitting", 222),
        ("Cyclist", 1_627),
        ("Tram", 511),
        ("Misc", 973),
    ];

    /// <summary>Labels of all types.</summary>
    public static int Labels { get; } = Training.Sum(type => type.Labels);
}
