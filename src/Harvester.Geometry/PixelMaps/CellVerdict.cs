namespace Harvester.Geometry.PixelMaps;

/// <summary>What to do about a cell: ask a place first, or leave it as it is understood, or divide it.</summary>
/// <param name="Wanted">The place to ask, or null.</param>
/// <param name="IsUnderstood">Whether its inside is known well enough; false when a place is wanted.</param>
/// <param name="Weight">What one wrong pixel in it counts at most.</param>
internal readonly record struct CellVerdict(Place? Wanted, bool IsUnderstood, double Weight)
{
    public static CellVerdict Ask(Place place, double weight) => new(place, false, weight);

    public static CellVerdict Understood(double weight) => new(null, true, weight);

    public static CellVerdict Divide(double weight) => new(null, false, weight);
}
