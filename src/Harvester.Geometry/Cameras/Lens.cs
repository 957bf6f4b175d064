namespace Harvester.Geometry.Cameras;

/// <summary>
/// How the picture deviates from an ideal pinhole camera's: a factor on the focal length, a shift of the principal point, and radial
/// distortion r' = r · (1 + k1 r² + k2 r⁴) of normalised image coordinates (r = distance from the optical axis at depth 1), the first two
/// radial terms of OpenCV's calib3d model. Before the polynomial would stop growing, it is continued as a straight line (from slope 0.1
/// on), so that the mapping is one-to-one everywhere; no calibrated image reaches that far. The default value is not a lens; start from
/// <see cref="Ideal"/>.
/// </summary>
public readonly record struct Lens
{
    private const double MinSlope = 0.1;

    // Far beyond the image, where r⁵ dominates, a step divides the error by 1.25 only.
    private const int NewtonSteps = 200;

    private readonly double _polynomialEnd;

    /// <summary>Creates a lens.</summary>
    /// <param name="focalScale">Factor on both focal lengths; greater than 0, 1 for an ideal lens.</param>
    /// <param name="centreOffsetX">Shift of the principal point to the right, as a fraction of the image's width.</param>
    /// <param name="centreOffsetY">Shift of the principal point downward, as a fraction of the image's height.</param>
    /// <param name="k1">Coefficient of r², no unit; negative is barrel distortion.</param>
    /// <param name="k2">Coefficient of r⁴, no unit.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is not finite, or the focal scale is not positive.</exception>
    public Lens(double focalScale, double centreOffsetX, double centreOffsetY, double k1, double k2)
    {
        FocalScale = Guard.Positive(focalScale, nameof(focalScale));
        CentreOffsetX = Guard.Finite(centreOffsetX, nameof(centreOffsetX));
        CentreOffsetY = Guard.Finite(centreOffsetY, nameof(centreOffsetY));
        K1 = Guard.Finite(k1, nameof(k1));
        K2 = Guard.Finite(k2, nameof(k2));
        _polynomialEnd = EndOfPolynomial(k1, k2);
    }

    /// <summary>An ideal pinhole camera: no scale, shift or distortion.</summary>
    public static Lens Ideal { get; } = new(1, 0, 0, 0, 0);

    /// <summary>Factor on both focal lengths.</summary>
    public double FocalScale { get; }

    /// <summary>Shift of the principal point to the right, as a fraction of the image's width.</summary>
    public double CentreOffsetX { get; }

    /// <summary>Shift of the principal point downward, as a fraction of the image's height.</summary>
    public double CentreOffsetY { get; }

    /// <summary>Coefficient of r², no unit; negative is barrel distortion.</summary>
    public double K1 { get; }

    /// <summary>Coefficient of r⁴, no unit.</summary>
    public double K2 { get; }

    /// <summary>Whether straight lines stay straight.</summary>
    public bool IsRectilinear => K1 == 0 && K2 == 0;

    /// <summary>Distorts an ideal normalised image point.</summary>
    public Vector2D Distort(Vector2D ideal)
    {
        double radius = ideal.Length;
        return IsRectilinear || radius == 0 ? ideal : ideal * (DistortRadius(radius) / radius);
    }

    /// <summary>The inverse of <see cref="Distort"/>, accurate to about 1e-15 of the radius.</summary>
    public Vector2D Undistort(Vector2D shown)
    {
        double radius = shown.Length;
        return IsRectilinear || radius == 0 ? shown : shown * (UndistortRadius(radius) / radius);
    }

    private static double EndOfPolynomial(double k1, double k2)
    {
        // The slope 1 + 3 k1 q + 5 k2 q², q = r², first reaches MinSlope at the smallest positive root of 5 k2 q² + 3 k1 q + c.
        const double c = 1 - MinSlope;
        double a = 5 * k2;
        double b = 3 * k1;
        double discriminant = (b * b) - (4 * a * c);
        if (discriminant < 0)
        {
            return double.PositiveInfinity;
        }

        double stable = -0.5 * (b + (b >= 0 ? 1 : -1) * Math.Sqrt(discriminant));
        double end = Math.Min(PositiveOrInfinity(c, stable), PositiveOrInfinity(stable, a));
        return Math.Sqrt(end);
    }

    private static double PositiveOrInfinity(double numerator, double denominator)
    {
        double root = denominator == 0 ? -1 : numerator / denominator;
        return root > 0 ? root : double.PositiveInfinity;
    }

    private double DistortRadius(double radius) =>
        radius <= _polynomialEnd ? Polynomial(radius) : Polynomial(_polynomialEnd) + (MinSlope * (radius - _polynomialEnd));

    private double UndistortRadius(double shown)
    {
        if (!double.IsInfinity(_polynomialEnd) && shown >= Polynomial(_polynomialEnd))
        {
            return _polynomialEnd + ((shown - Polynomial(_polynomialEnd)) / MinSlope);
        }

        // The slope is at least MinSlope below the polynomial's end, so the root lies within [0, shown / MinSlope].
        double low = 0;
        double high = Math.Min(_polynomialEnd, shown / MinSlope);
        double radius = Math.Min(shown, high);
        for (int step = 0; step < NewtonSteps; step++)
        {
            double error = Polynomial(radius) - shown;
            if (error > 0)
            {
                high = radius;
            }
            else
            {
                low = radius;
            }

            double q = radius * radius;
            double next = radius - (error / (1 + (3 * K1 * q) + (5 * K2 * q * q)));
            next = next >= low && next <= high ? next : (low + high) / 2;
            if (next == radius)
            {
                break;
            }

            radius = next;
        }

        return radius;
    }

    private double Polynomial(double radius)
    {
        double q = radius * radius;
        return radius * (1 + (q * (K1 + (q * K2))));
    }
}
