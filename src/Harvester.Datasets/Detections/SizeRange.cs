namespace Harvester.Datasets.Detections;

/// <summary>A range of areas, both ends included.</summary>
/// <param name="Name">Name in tables.</param>
/// <param name="Min">Smallest area, square pixels.</param>
/// <param name="Max">Largest area, square pixels.</param>
public sealed record SizeRange(string Name, double Min, double Max)
{
    private const double SmallSide = 32;
    private const double MediumSide = 96;
    private const double Everything = 1e10;

    /// <summary>COCO's ranges: all, small up to 32², medium up to 96², large.</summary>
    public static IReadOnlyList<SizeRange> Coco { get; } =
    [
        new("all", 0, Everything),
        new("small", 0, SmallSide * SmallSide),
        new("medium", SmallSide * SmallSide, MediumSide * MediumSide),
        new("large", MediumSide * MediumSide, Everything),
    ];

    /// <summary>Whether an area is in the range.</summary>
    public bool Has(double area) => area >= Min && area <= Max;
}
