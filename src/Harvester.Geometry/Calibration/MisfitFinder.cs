using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Calibration;

/// <summary>
/// Finds the likely cause of a disagreement. Each cause moves points in a pattern of its own, to first order; the one whose pattern
/// explains most of the squared distances is chosen, if it explains half of them.
/// </summary>
public static class MisfitFinder
{
    /// <summary>Minimum fraction of the squared distances that a cause must explain to be named.</summary>
    private const double MinExplained = 0.5;

    private delegate Vector2D Pattern(Vector2D point, double depth);

    // Points are normalised: x right, y down, at depth 1. Rotations about the other axes are, to first order, shifts of the principal
    // point.
    private static readonly (Misfit Cause, Pattern[] Patterns)[] Causes =
    [
        // A wrong aspect ratio: x grows with x alone.
        (Misfit.Stretch, [static (point, _) => new Vector2D(point.X, 0)]),
        // A small roll φ turns (x, y) by φ (-y, x).
        (Misfit.CameraRoll, [static (point, _) => new Vector2D(-point.Y, point.X)]),
        // With the camera off by (a, b, c) to the right, down and ahead, a point moves by (-a + c x, -b + c y) / depth.
        (
            Misfit.CameraPosition,
            [
                static (_, depth) => new Vector2D(1 / depth, 0),
                static (_, depth) => new Vector2D(0, 1 / depth),
                static (point, depth) => point * (1 / depth),
            ]
        ),
        (
            Misfit.LensShape,
            [
                // Brown's third radial term, k3 r⁶ (x, y), and his tangential ones, p1 (2xy, r² + 2y²) and p2 (r² + 2x², 2xy).
                static (point, _) => point * Math.Pow(point.Dot(point), 3),
                static (point, _) => new Vector2D(2 * point.X * point.Y, point.Dot(point) + (2 * point.Y * point.Y)),
                static (point, _) => new Vector2D(point.Dot(point) + (2 * point.X * point.X), 2 * point.X * point.Y),
            ]
        ),
    ];

    /// <summary>The cause whose pattern explains most of the distances between sightings and projections.</summary>
    /// <param name="camera">The camera with the fitted lens.</param>
    /// <param name="sightings">The sightings used for the fit, and further ones if there are any.</param>
    /// <exception cref="ArgumentException">A point lies nearer than the near plane.</exception>
    public static Misfit Of(CameraIntrinsics camera, IReadOnlyList<Sighting> sightings)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(sightings, nameof(sightings));
        Residual[] residuals = [.. sightings.Select(sighting => Residual.Of(camera, sighting))];

        // Without a pattern the lens parameters are fitted again, so that all causes start from the same sum.
        double all = LeftBy([], camera, residuals);
        (Misfit cause, double left) = Causes
            .Select(cause => (cause.Cause, Left: LeftBy(cause.Patterns, camera, residuals)))
            .OrderBy(cause => cause.Left)
            .First();
        return left < (1 - MinExplained) * all ? cause : Misfit.Noise;
    }

    /// <summary>
    /// The sum of squared distances that remains when a cause's patterns are fitted together with the lens parameters, which have adapted
    /// to the cause.
    /// </summary>
    private static double LeftBy(Pattern[] patterns, CameraIntrinsics camera, Residual[] residuals)
    {
        var equations = new LensEquations(camera);
        var system = new WeightedLeastSquares(LensEquations.ParameterCount + patterns.Length);
        foreach (Residual residual in residuals)
        {
            system.Add(RowU(residual), residual.Distance.X, 1);
            system.Add(RowV(residual), residual.Distance.Y, 1);
        }

        return system.Solve() is { } solution
            ? residuals.Sum(residual =>
                Square(residual.Distance.X - Dot(RowU(residual), solution)) + Square(residual.Distance.Y - Dot(RowV(residual), solution))
            )
            : double.PositiveInfinity;

        double[] RowU(Residual residual) =>
            [.. equations.RowU(residual.Point), .. patterns.Select(pattern => camera.Fx * pattern(residual.Point, residual.Depth).X)];

        double[] RowV(Residual residual) =>
            [.. equations.RowV(residual.Point), .. patterns.Select(pattern => camera.Fy * pattern(residual.Point, residual.Depth).Y)];
    }

    private static double Dot(double[] a, double[] b) => a.Zip(b, static (x, y) => x * y).Sum();

    private static double Square(double value) => value * value;

    private readonly record struct Residual(Vector2D Point, double Depth, Vector2D Distance)
    {
        public static Residual Of(CameraIntrinsics camera, Sighting sighting) =>
            new(
                LensEquations.PointOf(sighting),
                sighting.CameraPose.ToLocal(sighting.World).Y,
                sighting.Pixel - new Camera(sighting.CameraPose, camera).Project(sighting.World).Pixel
            );
    }
}
