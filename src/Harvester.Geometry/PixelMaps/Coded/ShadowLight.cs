namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>
/// What shadows in a frame look like. In a full shadow only the light of the sky is left, which is a fraction A of all light, channel by
/// channel; less of it where the object also covers part of the sky. At the border some of the sun's light, B = 1 - A, remains. So a shaded
/// pixel has the colour behind it times a·A + s·B, with a from <see cref="MinSky"/> to 1 and s from 0 to 1. A is found where something
/// outside all silhouettes changes with an object.
/// </summary>
internal sealed class ShadowLight
{
    /// <summary>Fraction of the sky's light that is left at least.</summary>
    private const double MinSky = 0.3;

    /// <summary>Deviation of shadows from this model, as a fraction of the light.</summary>
    private const double Slack = 0.02;

    /// <summary>Fewer shaded pixels than this tell nothing.</summary>
    private const int MinPixels = 12;

    /// <summary>The full shadow is the mean of this fraction of the shaded pixels, the darkest.</summary>
    private const double DarkestFraction = 0.3;

    /// <summary>Logarithm of how much more likely a ratio in the surface of shadows is for a shadow than for any object.</summary>
    private const double InSurface = 2;

    /// <summary>Ratios of a shaded to a lit colour from here on are no shadow; a little over 1 allows for noise.</summary>
    private const double MaxRatio = 1.02;

    /// <summary>Below this fraction of the product of its diagonal, the determinant of the equations is rounding.</summary>
    private const double Singular = 1e-9;

    private readonly List<Vector3D> _ratios = [];
    private Vector3D _sky;
    private Vector3D _sun;

    /// <summary>Whether any shadows were found.</summary>
    public bool IsAny => _ratios.Count >= MinPixels;

    /// <summary>The fraction of the light that a full shadow leaves.</summary>
    public Vector3D Sky => _sky;

    /// <summary>Adds a pixel outside all silhouettes that changes with an object.</summary>
    public void Add(Vector3D shaded, Vector3D lit)
    {
        var ratio = new Vector3D(shaded.X / Math.Max(1, lit.X), shaded.Y / Math.Max(1, lit.Y), shaded.Z / Math.Max(1, lit.Z));
        if (ratio.X is > 0 and < MaxRatio && ratio.Y is > 0 and < MaxRatio && ratio.Z is > 0 and < MaxRatio)
        {
            _ratios.Add(ratio);
        }
    }

    /// <summary>Finds A and B from the pixels added so far.</summary>
    public void Solve()
    {
        if (!IsAny)
        {
            return;
        }

        // The border of a shadow is lighter than its inside, so the darkest ratios are those of full shadows. Their mean is A; B = 1 - A.
        List<Vector3D> darkest =
        [
            .. _ratios.OrderBy(ratio => ratio.X + ratio.Y + ratio.Z).Take((int)Math.Ceiling(DarkestFraction * _ratios.Count)),
        ];
        _sky = darkest.Aggregate(Vector3D.Zero, (sum, ratio) => sum + ratio) / darkest.Count;
        _sun = new Vector3D(1, 1, 1) - _sky;
    }

    /// <summary>How much more likely a colour is as a shaded background than as any object's colour, as a logarithm.</summary>
    /// <param name="shaded">The colour with the object.</param>
    /// <param name="lit">The colour without it.</param>
    /// <param name="variance">Noise of the first, squared grey levels.</param>
    /// <param name="litVariance">Noise of the second.</param>
    public double Evidence(Vector3D shaded, Vector3D lit, double variance, double litVariance)
    {
        // Least squares for a and s in shaded = a·A·lit + s·B·lit; each channel is weighted by its inverse variance. The normal equations
        // are aa·a + ab·s = ay and ab·a + bb·s = by.
        var basisSky = new Vector3D(_sky.X * lit.X, _sky.Y * lit.Y, _sky.Z * lit.Z);
        var basisSun = new Vector3D(_sun.X * lit.X, _sun.Y * lit.Y, _sun.Z * lit.Z);
        var weight = new Vector3D(
            1 / VarianceOf(shaded.X, lit.X, variance, litVariance),
            1 / VarianceOf(shaded.Y, lit.Y, variance, litVariance),
            1 / VarianceOf(shaded.Z, lit.Z, variance, litVariance)
        );
        double aa = Dot(basisSky, basisSky, weight);
        double ab = Dot(basisSky, basisSun, weight);
        double bb = Dot(basisSun, basisSun, weight);
        double ay = Dot(basisSky, shaded, weight);
        double by = Dot(basisSun, shaded, weight);
        double determinant = (aa * bb) - (ab * ab);
        double sun = determinant > Singular * aa * bb ? ((aa * by) - (ab * ay)) / determinant : 0;

        // Both are limited to their ranges in turn: s, then the best a for that s, then the best s for that a.
        sun = Math.Max(0, Math.Min(1, sun));
        double sky = Math.Max(MinSky, Math.Min(1, (ay - (sun * ab)) / Math.Max(Singular, aa)));
        sun = Math.Max(0, Math.Min(1, (by - (sky * ab)) / Math.Max(Singular, bb)));

        // -½ Σ rest² / variance is the logarithm of the likelihood of a shadow; an object's colour could be any, as InSurface says.
        Vector3D rest = shaded - (basisSky * sky) - (basisSun * sun);
        return InSurface - (Dot(rest, rest, weight) / 2);
    }

    private static double VarianceOf(double shaded, double lit, double variance, double litVariance)
    {
        // shaded - ratio·lit has the variance of both, the second times ratio², plus the model's own deviation.
        double ratio = Math.Min(1, shaded / Math.Max(1, lit));
        double slack = Slack * lit;
        return variance + (ratio * ratio * litVariance) + (slack * slack);
    }

    private static double Dot(Vector3D a, Vector3D b, Vector3D weight) =>
        (a.X * b.X * weight.X) + (a.Y * b.Y * weight.Y) + (a.Z * b.Z * weight.Z);
}
