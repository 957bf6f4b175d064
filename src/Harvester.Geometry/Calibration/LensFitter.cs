using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Calibration;

/// <summary>
/// Fits a <see cref="Lens"/> to sightings. The model is linear in its parameters (<see cref="LensEquations"/>), so there is one optimum and
/// no start value. Wrong sightings are tolerated as long as most are right: least squares are solved repeatedly with weights, first Huber's
/// (which converge from anywhere), then Tukey's biweight (which removes the influence of outliers); the scale of the noise is estimated
/// from the median distance each time (Huber and Ronchetti, Robust Statistics, chapter 7).
/// </summary>
public static class LensFitter
{
    /// <summary>Minimum number of sightings that must agree: five parameters, two equations each, and some to check the result.</summary>
    public const int MinSightings = 10;

    // The median distance of noise that is normal in both axes, in standard deviations of one axis: √(2 ln 2).
    private const double MedianOfRayleigh = 1.1774100225154747;

    // Huber's usual bound, in standard deviations: 95 % as efficient as least squares if all noise is normal.
    private const double HuberBound = 1.345;

    // Noise exceeds this many standard deviations with a probability of exp(-18), so only wrong sightings are rejected.
    private const double BiweightBound = 6;

    // Markers cannot be located better than this, pixels; sightings without noise then do not reject each other because of rounding.
    private const double MinNoise = 0.01;

    // Rounds with either weight. The fit is well converged by then; LensFitterTests compares it with the true lens.
    private const int Rounds = 30;

    /// <summary>Fits the lens that projects the sightings' points closest to where they are seen.</summary>
    /// <param name="camera">Field of view, image size and aspect ratio; its own lens is ignored.</param>
    /// <param name="sightings">Points in front of the camera and where they are seen.</param>
    /// <exception cref="ArgumentException">A point lies nearer than the near plane.</exception>
    public static LensFit Fit(CameraIntrinsics camera, IReadOnlyList<Sighting> sightings)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(sightings, nameof(sightings));
        CameraIntrinsics ideal = WithLens(camera, Lens.Ideal);
        double[] distances = DistancesOf(ideal, sightings);
        if (sightings.Count < MinSightings)
        {
            return Without(LensFitOutcome.TooFewSightings);
        }

        var equations = new LensEquations(ideal);
        double[] weights = [.. Enumerable.Repeat(1.0, sightings.Count)];
        for (int round = 0; round < 2 * Rounds; round++)
        {
            if (Solve(equations, sightings, weights) is not { } lens)
            {
                return Without(LensFitOutcome.Undetermined);
            }

            distances = DistancesOf(WithLens(camera, lens), sightings);

            // Standard deviation of one axis: the median distance divided by that of a Rayleigh distribution. It holds while fewer than
            // half of the sightings are wrong.
            double noise = Math.Max(MinNoise, Median(distances) / MedianOfRayleigh);
            Func<double, double> weight = round < Rounds ? HuberWeight : BiweightWeight;
            weights = [.. distances.Select(distance => weight(distance / noise))];
        }

        return Result(camera, equations, sightings, weights);
    }

    private static LensFit Result(CameraIntrinsics camera, LensEquations equations, IReadOnlyList<Sighting> sightings, double[] weights)
    {
        List<Sighting> used = [.. sightings.Where((_, i) => weights[i] > 0)];
        if (used.Count < MinSightings || 2 * used.Count < sightings.Count)
        {
            return Without(LensFitOutcome.TooFewSightings);
        }

        var system = SystemOf(equations, sightings, weights);
        if (LensOf(system) is not { } lens)
        {
            return Without(LensFitOutcome.Undetermined);
        }

        var error = ReprojectionError.Of(WithLens(camera, lens), used);

        // Variance of one axis: Σ distance² / (2n - 5), since n sightings give 2n equations and five parameters are fitted. The mean square
        // of distances is Σ distance² / n.
        double variance = error.RmsPixels * error.RmsPixels * used.Count / ((2 * used.Count) - LensEquations.ParameterCount);
        double corner = Math.Sqrt(variance * CornerVariance(camera, equations, system));
        return new LensFit(
            LensFitOutcome.Fitted,
            lens,
            error,
            ReprojectionError.Of(WithLens(camera, Lens.Ideal), used),
            sightings.Count - used.Count,
            corner
        );
    }

    private static double CornerVariance(CameraIntrinsics camera, LensEquations equations, WeightedLeastSquares system)
    {
        // The corners of the image at depth 1: y = ± tan(vertical field of view / 2), x = y times the aspect ratio. There r⁵ and r³ are
        // largest, and with them the uncertainty of the fit.
        double tangent = Math.Tan(Angles.ToRadians(camera.VerticalFovDegrees) / 2);
        double largest = 0;
        foreach (int side in new[] { -1, 1 })
        {
            foreach (int end in new[] { -1, 1 })
            {
                var corner = new Vector2D(side * tangent * camera.WindowAspect, end * tangent);
                largest = Math.Max(largest, system.VarianceOf(equations.RowU(corner)) + system.VarianceOf(equations.RowV(corner)));
            }
        }

        return largest;
    }

    private static Lens? Solve(LensEquations equations, IReadOnlyList<Sighting> sightings, double[] weights) =>
        LensOf(SystemOf(equations, sightings, weights));

    private static Lens? LensOf(WeightedLeastSquares system) =>
        system.Solve() is { } parameters && parameters[0] > 0 ? LensEquations.LensOf(parameters) : null;

    private static WeightedLeastSquares SystemOf(LensEquations equations, IReadOnlyList<Sighting> sightings, double[] weights)
    {
        var system = new WeightedLeastSquares(LensEquations.ParameterCount);
        for (int i = 0; i < sightings.Count; i++)
        {
            Vector2D point = LensEquations.PointOf(sightings[i]);
            system.Add(equations.RowU(point), equations.TargetU(sightings[i].Pixel), weights[i]);
            system.Add(equations.RowV(point), equations.TargetV(sightings[i].Pixel), weights[i]);
        }

        return system;
    }

    private static double[] DistancesOf(CameraIntrinsics camera, IReadOnlyList<Sighting> sightings) =>
        [.. sightings.Select(sighting => ReprojectionError.Distance(camera, sighting))];

    // w = min(1, c / d).
    private static double HuberWeight(double distance) => distance <= HuberBound ? 1 : HuberBound / distance;

    private static double BiweightWeight(double distance)
    {
        // w = (1 - (d / c)²)² up to d = c, 0 beyond.
        double rest = 1 - (distance * distance / (BiweightBound * BiweightBound));
        return rest > 0 ? rest * rest : 0;
    }

    private static double Median(double[] values)
    {
        double[] sorted = [.. values];
        Array.Sort(sorted);
        return (sorted[(sorted.Length - 1) / 2] + sorted[sorted.Length / 2]) / 2;
    }

    private static CameraIntrinsics WithLens(CameraIntrinsics camera, Lens lens) =>
        new(camera.VerticalFovDegrees, camera.Image, camera.WindowAspect, camera.NearClip, lens);

    private static LensFit Without(LensFitOutcome outcome) => new(outcome, Lens.Ideal, default, default, 0, 0);
}
