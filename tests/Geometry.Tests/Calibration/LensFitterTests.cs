using FsCheck;
using FsCheck.Fluent;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;
using Harvester.TestSupport;

namespace Harvester.Geometry.Tests.Calibration;

public sealed class LensFitterTests
{
    // The required accuracy of a calibrated camera, pixels over the whole image.
    private const double MaxRms = 0.3;
    private const double MaxError = 1;
    private static readonly Lens Injected = new(1.008, 0, 0, -0.02, 0);

    [Fact]
    public void Fit_of_exact_sightings_finds_the_lens()
    {
        // Solved by normal equations, whose condition squares that of the rows: 1e-16 becomes some 1e-10.
        const double tolerance = 1e-9;
        Arbitrary<double[]> deviations = RandomCases.ArrayOf(RandomCases.Number(-0.01, 0.01), 5);
        RandomCases.Check(
            20,
            Arb.Zip(deviations, Arb.Zip(RandomCases.Number(40, 90), RandomCases.Integer(0, 1_000))),
            drawn =>
            {
                (double[] by, (double fov, int seed)) = drawn;
                var lens = new Lens(1 + (5 * by[0]), 2 * by[1], 2 * by[2], 5 * by[3], by[4]);
                CameraIntrinsics truth = Intrinsics(800, 600, fov, lens);

                LensFit fit = LensFitter.Fit(Intrinsics(800, 600, fov, Lens.Ideal), Sightings(truth, new Random(seed), 0, 0));

                Assert.Equal(LensFitOutcome.Fitted, fit.Outcome);
                Assert.Equal(lens.FocalScale, fit.Lens.FocalScale, tolerance);
                Assert.Equal(lens.CentreOffsetX, fit.Lens.CentreOffsetX, tolerance);
                Assert.Equal(lens.CentreOffsetY, fit.Lens.CentreOffsetY, tolerance);
                Assert.Equal(lens.K1, fit.Lens.K1, tolerance);
                Assert.Equal(lens.K2, fit.Lens.K2, tolerance);
                Assert.Equal(0, fit.OutlierCount);
            }
        );
    }

    [Theory]
    [InlineData(800, 600, 50)]
    [InlineData(800, 600, 90)]
    [InlineData(1920, 1080, 50)]
    [InlineData(1920, 1080, 90)]
    public void Fit_of_noisy_sightings_with_outliers_holds_across_the_image(int width, int height, double fov)
    {
        const double noisePixels = 0.25;
        const double wrongFraction = 0.2;
        CameraIntrinsics truth = Intrinsics(width, height, fov, Injected);
        CameraIntrinsics before = Intrinsics(width, height, fov, Lens.Ideal);

        LensFit fit = LensFitter.Fit(before, Sightings(truth, new Random(2), noisePixels, wrongFraction));

        (_, double maxBefore) = ErrorOverImage(truth, before);
        (double rms, double max) = ErrorOverImage(truth, Intrinsics(width, height, fov, fit.Lens));

        // At 50 degrees and 4:3 the two defects work against each other; there they leave 2.2 px in the corners, elsewhere 10 and more.
        Assert.True(maxBefore > (width == 800 && fov == 50 ? 2 : 10), $"the lens hardly matters before: {maxBefore:F2} px at most");
        Assert.True(fit.ErrorWithout.MaxPixels > maxBefore / 2, $"reported {fit.ErrorWithout.MaxPixels:F2} px before");
        Assert.True(rms <= MaxRms, $"{rms:F3} px RMS after");
        Assert.True(max <= MaxError, $"{max:F3} px at most after");
    }

    [Theory]
    [InlineData(0)]
    [InlineData(0.1)]
    [InlineData(0.3)]
    [InlineData(0.4)]
    public void Fit_rejects_exactly_the_wrong_sightings(double wrongFraction)
    {
        CameraIntrinsics truth = Intrinsics(800, 600, 60, Injected);
        List<Sighting> sightings = Sightings(truth, new Random(3), 0.1, wrongFraction);

        LensFit fit = LensFitter.Fit(Intrinsics(800, 600, 60, Lens.Ideal), sightings);

        Assert.Equal((int)(wrongFraction * sightings.Count), fit.OutlierCount);
        Assert.Equal(sightings.Count, fit.Error.Count + fit.OutlierCount);

        // Noise of 0.1 px in both axes: 0.1 · √2 = 0.141 px RMS distance.
        Assert.Equal(0.141, fit.Error.RmsPixels, 0.02);
    }

    [Fact]
    public void Fit_ignores_the_current_lens_of_the_camera()
    {
        CameraIntrinsics truth = Intrinsics(800, 600, 60, Injected);
        List<Sighting> sightings = Sightings(truth, new Random(4), 0.2, 0.1);

        Assert.Equal(
            LensFitter.Fit(Intrinsics(800, 600, 60, Lens.Ideal), sightings),
            LensFitter.Fit(Intrinsics(800, 600, 60, new Lens(1.2, 0.1, -0.1, 0.2, 0.1)), sightings)
        );
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Fit_reports_the_uncertainty_at_the_corners()
    {
        const double noisePixels = 0.3;
        const int trials = 100;
        CameraIntrinsics truth = Intrinsics(800, 600, 60, Injected);
        var random = new Random(5);
        double[] squares = new double[4];
        double reported = 0;
        for (int i = 0; i < trials; i++)
        {
            LensFit fit = LensFitter.Fit(truth, Sightings(truth, random, noisePixels, 0));
            reported += fit.CornerUncertaintyPixels / trials;
            CameraIntrinsics found = Intrinsics(800, 600, 60, fit.Lens);
            for (int corner = 0; corner < 4; corner++)
            {
                double error = ErrorAt(truth, found, 800 * (corner % 2), 600 * (corner / 2));
                squares[corner] += error * error / trials;
            }
        }

        // 100 trials know a standard deviation to 1 / √(2 · 100) = 7 %; the lens moves the corners by 2 %, and the weights cost a little.
        double seen = Math.Sqrt(squares.Max());
        Assert.InRange(reported / seen, 0.8, 1.2);
    }

    [Fact]
    public void Fit_of_central_sightings_is_uncertain_at_the_corners()
    {
        CameraIntrinsics truth = Intrinsics(800, 600, 60, Injected);
        List<Sighting> all = Sightings(truth, new Random(6), 0.2, 0);
        List<Sighting> middle = [.. all.Where(sighting => (sighting.Pixel - new Vector2D(400, 300)).Length < 200)];

        double unsure = LensFitter.Fit(truth, middle).CornerUncertaintyPixels;

        Assert.True(unsure > 1 && unsure > 10 * LensFitter.Fit(truth, all).CornerUncertaintyPixels, $"{unsure:F2} px");
    }

    [Fact]
    public void Fit_of_too_few_sightings_has_no_result()
    {
        CameraIntrinsics truth = Intrinsics(800, 600, 60, Injected);
        List<Sighting> nine = [.. Sightings(truth, new Random(7), 0, 0).Take(LensFitter.MinSightings - 1)];

        Assert.Equal(new LensFit(LensFitOutcome.TooFewSightings, Lens.Ideal, default, default, 0, 0), LensFitter.Fit(truth, nine));
        Assert.Equal(LensFitOutcome.TooFewSightings, LensFitter.Fit(truth, []).Outcome);
    }

    [Fact]
    public void Fit_of_wrong_sightings_only_has_a_large_error()
    {
        CameraIntrinsics truth = Intrinsics(800, 600, 60, Injected);

        LensFit fit = LensFitter.Fit(truth, Sightings(truth, new Random(8), 0, 1));

        Assert.True(fit.Outcome != LensFitOutcome.Fitted || fit.Error.RmsPixels > 50);
    }

    [Fact]
    public void Fit_of_sightings_on_a_circle_or_at_a_point_is_undetermined()
    {
        CameraIntrinsics truth = Intrinsics(800, 600, 60, Lens.Ideal);
        var camera = new Camera(Pose(), truth);
        List<Sighting> place = [.. Enumerable.Repeat(At(camera, 20, 300), 30)];
        List<Sighting> circle = [.. Enumerable.Range(0, 30).Select(i => At(camera, 400 + (200 * Math.Cos(i)), 300 + (200 * Math.Sin(i))))];

        Assert.Equal(LensFitOutcome.Undetermined, LensFitter.Fit(truth, place).Outcome);
        Assert.Equal(LensFitOutcome.Undetermined, LensFitter.Fit(truth, circle).Outcome);
    }

    [Fact]
    public void Fit_of_a_point_behind_the_camera_is_refused()
    {
        CameraIntrinsics truth = Intrinsics(800, 600, 60, Lens.Ideal);
        Pose pose = Pose();
        var behind = new Sighting(pose, pose.ToWorld(new Vector3D(0, -1, 0)), new Vector2D(400, 300));

        Assert.Throws<ArgumentException>(() => LensFitter.Fit(truth, [behind]));
    }

    private static Sighting At(Camera camera, double u, double v) => new(camera.Pose, camera.Unproject(u, v, 2), new Vector2D(u, v));

    /// <summary>Sightings of a grid over the image; noise is normal, wrong ones lie 10 to 200 pixels off.</summary>
    private static List<Sighting> Sightings(CameraIntrinsics truth, Random random, double noisePixels, double wrongFraction)
    {
        var camera = new Camera(
            Pose(),
            new CameraIntrinsics(truth.VerticalFovDegrees, truth.Image, truth.WindowAspect, truth.NearClip, Lens.Ideal)
        );
        var sees = new Camera(camera.Pose, truth);
        IReadOnlyList<PlannedMarker> markers = MarkerPlan.Across(camera, 15, 11, 6, [1, 1.5, 2]).Markers;
        int wrong = (int)(wrongFraction * markers.Count);
        int[] order = [.. Enumerable.Range(0, markers.Count)];
        random.Shuffle(order);
        return
        [
            .. order.Select(
                (index, place) =>
                {
                    Vector2D seen =
                        sees.Project(markers[index].Centre).Pixel + (new Vector2D(Normal(random), Normal(random)) * noisePixels);
                    double angle = random.Between(0, 2 * Math.PI);
                    Vector2D off = new Vector2D(Math.Cos(angle), Math.Sin(angle)) * random.Between(10, 200);
                    return new Sighting(camera.Pose, markers[index].Centre, place < wrong ? seen + off : seen);
                }
            ),
        ];
    }

    /// <summary>Box and Muller's normal variate.</summary>
    private static double Normal(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());

    private static (double Rms, double Max) ErrorOverImage(CameraIntrinsics truth, CameraIntrinsics found)
    {
        const int steps = 40;
        double sum = 0;
        double max = 0;
        for (int i = 0; i <= steps; i++)
        {
            for (int j = 0; j <= steps; j++)
            {
                double error = ErrorAt(truth, found, truth.Image.Width * i / (double)steps, truth.Image.Height * j / (double)steps);
                sum += error * error;
                max = Math.Max(max, error);
            }
        }

        return (Math.Sqrt(sum / ((steps + 1) * (steps + 1))), max);
    }

    private static double ErrorAt(CameraIntrinsics truth, CameraIntrinsics found, double u, double v)
    {
        Vector3D point = new Camera(Pose(), truth).Unproject(u, v, 10);
        return (new Camera(Pose(), found).Project(point).Pixel - new Vector2D(u, v)).Length;
    }

    private static Pose Pose() => new(new Vector3D(1200, -340, 31), Axes.FromEuler(new EulerAngles(-3, 1, 77)));

    private static CameraIntrinsics Intrinsics(int width, int height, double fov, Lens lens) =>
        new(fov, new ImageSize(width, height), (double)width / height, 0.1, lens);
}
