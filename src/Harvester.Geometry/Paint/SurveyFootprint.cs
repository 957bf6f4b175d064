namespace Harvester.Geometry.Paint;

/// <summary>The rectangle of ground that a camera shows when it looks straight down.</summary>
public readonly record struct SurveyFootprint
{
    /// <summary>
    /// Ground at the border that does not count, metres: a stripe needs ground on both sides, and a car is placed with some error.
    /// </summary>
    private const double Border = 1;

    /// <summary>Creates a footprint.</summary>
    /// <param name="alongMetres">Its length along the road, metres; more than 4.</param>
    /// <param name="acrossMetres">Its width across the road, metres; more than 4.</param>
    /// <exception cref="ArgumentOutOfRangeException">A side is too short.</exception>
    public SurveyFootprint(double alongMetres, double acrossMetres)
    {
        Guard.InOpenRange(alongMetres, 4 * Border, double.MaxValue, nameof(alongMetres));
        Guard.InOpenRange(acrossMetres, 4 * Border, double.MaxValue, nameof(acrossMetres));
        HalfAlong = Math.Min((alongMetres / 2) - Border, PaintScanner.MaxDistance - Border);
        HalfAcross = (acrossMetres / 2) - Border;
    }

    /// <summary>Half of the length in which paint is found, metres.</summary>
    public double HalfAlong { get; }

    /// <summary>Half of the width in which paint is found, metres.</summary>
    public double HalfAcross { get; }
}
