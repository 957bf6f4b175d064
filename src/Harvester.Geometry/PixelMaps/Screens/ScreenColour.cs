namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>
/// The colour of a screen as a picture shows it, which air between screen and camera may change, and how much of a pixel is the screen's.
/// </summary>
internal sealed class ScreenColour
{
    /// <summary>The colour is the mean of at least this many pixels.</summary>
    private const int MinPixels = 6;

    /// <summary>A screen whose colour is weaker is not recognised.</summary>
    private const double MinStrength = 40;

    /// <summary>The strongest of this many pixels are the screen's, and those weaker by no more than this.</summary>
    private const int StrongestOf = 20;
    private const double StrengthSpread = 30;

    private readonly Vector3D _colour;
    private readonly double _strength;

    private ScreenColour(Vector3D colour) => (_colour, _strength) = (colour, StrengthOf(colour));

    /// <summary>The colour in the pictures of an object; null if the screen is not seen.</summary>
    public static ScreenColour? In(ScreenView view)
    {
        List<Vector3D> colours = [];
        for (int index = 0; index < view.HasShown.Length; index++)
        {
            if (view.HasShown[index])
            {
                colours.Add(view.Shown(index));
            }

            if (view.HasEmpty[index])
            {
                colours.Add(view.Empty(index));
            }
        }

        colours.Sort(static (a, b) => StrengthOf(b).CompareTo(StrengthOf(a)));
        if (colours.Count <= MinPixels)
        {
            return null;
        }

        // The strongest are skipped as chance: a twentieth of the pixels, at most six. Those from there on down to the spread are averaged.
        double strongest = StrengthOf(colours[Math.Min(MinPixels, colours.Count / StrongestOf)]);
        (Vector3D sum, int count) = (Vector3D.Zero, 0);
        for (; count < colours.Count && StrengthOf(colours[count]) > strongest - StrengthSpread; count++)
        {
            sum += colours[count];
        }

        var found = new ScreenColour(sum / Math.Max(1, count));
        return count >= MinPixels && found._strength >= MinStrength ? found : null;
    }

    /// <summary>The screen's share of a pixel if the rest is grey.</summary>
    public double ShareOf(Vector3D colour) => StrengthOf(colour) / _strength;

    /// <summary>The screen's share of a pixel if the rest has a known colour; 1 if that is the screen's own.</summary>
    public double ShareOf(Vector3D colour, Vector3D other)
    {
        Vector3D span = _colour - other;
        double squared = span.Dot(span);

        // Least squares for colour = other + share·(screen - other).
        return squared < MinStrength * MinStrength ? 1 : (colour - other).Dot(span) / squared;
    }

    /// <summary>A colour without the screen's share.</summary>
    public Vector3D Without(Vector3D colour, double share) => colour - (_colour * share);

    /// <summary>
    /// Explains a pixel by the screen's colour and another, which may be brighter or darker: the screen's share, and how far the
    /// explanation is from the pixel, grey levels.
    /// </summary>
    public (double Share, double Left) Mixture(Vector3D colour, Vector3D other)
    {
        // Least squares for colour = a·other + share·screen, with a weak wish that both add up to 1 in case the colours are alike.
        // The wish is the squared residual 25·(1 - a - share)²: 5 grey levels if the sum is off by 1.
        const double wish = 5 * 5;
        double oo = other.Dot(other) + wish;
        double os = other.Dot(_colour) + wish;
        double ss = _colour.Dot(_colour) + wish;
        double co = colour.Dot(other) + wish;
        double cs = colour.Dot(_colour) + wish;
        double determinant = Math.Max(1, (oo * ss) - (os * os));
        double a = Math.Max(0, ((co * ss) - (cs * os)) / determinant);
        double share = Math.Max(0, Math.Min(1, ((cs * oo) - (co * os)) / determinant));
        return (share, (colour - (other * a) - (_colour * share)).Length);
    }

    /// <summary>How much a colour is that of sheets: 255 for theirs, 0 for grey.</summary>
    // Sheets are magenta: red and blue without green.
    private static double StrengthOf(Vector3D colour) => ((colour.X + colour.Z) / 2) - colour.Y;
}
