namespace Harvester.Geometry.PixelMaps;

/// <summary>What to do with a cell: sample a point first, leave it as it is resolved, or divide it.</summary>
/// <param name="Wanted">The point to sample, or null.</param>
/// <param name="IsResolved">Whether its inside is known well enough; false if a point is wanted.</param>
/// <param name="Weight">Maximum weight of one wrong pixel in it.</param>
internal readonly record struct CellVerdict(SubpixelPoint? Wanted, bool IsResolved, double Weight)
{
    public static CellVerdict Sample(SubpixelPoint place, double weight) => new(place, false, weight);

    public static CellVerdict Resolved(double weight) => new(null, true, weight);

    public static CellVerdict Divide(double weight) => new(null, false, weight);
}
