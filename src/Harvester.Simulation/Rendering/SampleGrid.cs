namespace Harvester.Simulation.Rendering;

/// <summary>
/// The position in the pinhole image of each pixel's centre of a distorted image. The lens maps a normalised radius r to r (1 + k1 r² + k2
/// r⁴), continued as a straight line once the slope has fallen to 0.1; the grid holds the inverse.
/// </summary>
internal sealed class SampleGrid
{
    private const double MinSlope = 0.1;

    /// <summary>Radius up to which the slope is examined: 89.1 degrees from the axis.</summary>
    private const double MaxRadius = 64;
    private readonly RenderLens _lens;
    private readonly double _end;

    public SampleGrid(RenderCamera camera)
    {
        _lens = camera.Lens;
        _end = EndOfPolynomial();
        U = new double[camera.Width * camera.Height];
        V = new double[U.Length];
        Parallel.For(
            0,
            camera.Height,
            row =>
            {
                double y = (row + 0.5 - camera.CentreY) / camera.FocalY;
                for (int column = 0; column < camera.Width; column++)
                {
                    double x = (column + 0.5 - camera.CentreX) / camera.FocalX;
                    double shown = Math.Sqrt((x * x) + (y * y));
                    double factor = shown == 0 ? 1 : RadiusShownAt(shown) / shown;
                    int pixel = (row * camera.Width) + column;
                    U[pixel] = camera.CentreX + (camera.FocalX * x * factor);
                    V[pixel] = camera.CentreY + (camera.FocalY * y * factor);
                }
            }
        );
    }

    /// <summary>Pixels from the left in the pinhole's image, row by row.</summary>
    public double[] U { get; }

    /// <summary>Pixels from the top in the pinhole's image, row by row.</summary>
    public double[] V { get; }

    /// <summary>The minimum and maximum factor by which the lens scales points whose normalised radius lies between two values.</summary>
    public (double Minimum, double Maximum) FactorsBetween(double low, double high)
    {
        double atLow = FactorAt(low);
        double atHigh = FactorAt(high);
        double least = Math.Min(atLow, atHigh);
        double greatest = Math.Max(atLow, atHigh);

        // 1 + k1 q + k2 q² has its extremum at q = -k1 / (2 k2).
        double turn = _lens.K2 == 0 ? -1 : -_lens.K1 / (2 * _lens.K2);
        double turningRadius = turn > 0 ? Math.Sqrt(turn) : -1;
        if (turningRadius > low && turningRadius < high && turningRadius < _end)
        {
            least = Math.Min(least, FactorAt(turningRadius));
            greatest = Math.Max(greatest, FactorAt(turningRadius));
        }

        return (least, greatest);
    }

    private double EndOfPolynomial()
    {
        const double step = 1.0 / 4096;
        double radius = 0;
        while (radius < MaxRadius && SlopeAt(radius) >= MinSlope)
        {
            radius += step;
        }

        return radius < MaxRadius
            ? Halve(Math.Max(0, radius - step), radius, middle => SlopeAt(middle) < MinSlope)
            : double.PositiveInfinity;
    }

    private double RadiusShownAt(double shown)
    {
        // Newton's method needs few steps; if it does not converge, bisection does.
        double radius = Math.Min(shown, _end);
        for (int step = 0; step < 20; step++)
        {
            // Newton's method for r·factor(r) = shown.
            double next = radius - (((radius * FactorAt(radius)) - shown) / (radius <= _end ? SlopeAt(radius) : MinSlope));
            if (Math.Abs(next - radius) <= 1e-13 * shown)
            {
                return next;
            }

            radius = Math.Max(0, next);
        }

        return Halve(0, Math.Max(MaxRadius, shown / MinSlope), middle => middle * FactorAt(middle) > shown);
    }

    private static double Halve(double low, double high, Func<double, bool> isAbove)
    {
        for (int step = 0; step < 64 && low < high; step++)
        {
            double middle = (low + high) / 2;
            (low, high) = isAbove(middle) ? (low, middle) : (middle, high);
        }

        return (low + high) / 2;
    }

    private double FactorAt(double radius)
    {
        if (radius <= _end)
        {
            return Polynomial(radius);
        }

        return ((Polynomial(_end) * _end) + (MinSlope * (radius - _end))) / radius;
    }

    private double Polynomial(double radius) => 1 + (radius * radius * (_lens.K1 + (_lens.K2 * radius * radius)));

    private double SlopeAt(double radius) => 1 + (3 * _lens.K1 * radius * radius) + (5 * _lens.K2 * radius * radius * radius * radius);
}
