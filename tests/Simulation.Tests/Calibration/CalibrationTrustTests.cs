using Harvester.Capture.Calibration;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Rendering;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Calibration;

/// <summary>Whether a calibration is as good as it says, and says why when it refuses.</summary>
public sealed class CalibrationTrustTests(ITestOutputHelper output)
{
    [Fact]
    [Trait("Category", "Heavy")]
    public void Uncertainty_holds_in_95_of_100_calibrations()
    {
        int trials = ProofSize.Of(inCi: 25, full: 100);
        var random = new Random(2024);
        var ratios = new List<double>();
        for (int trial = 0; trial < trials; trial++)
        {
            bool rains = trial % 5 == 0;
            var lens = new RenderLens(
                Between(random, 0.97, 1.03),
                Between(random, -0.02, 0.02),
                Between(random, -0.02, 0.02),
                Between(random, -0.04, 0.04),
                Between(random, -0.005, 0.005)
            );
            var image = trial % 4 == 0 ? new ImageSize(640, 480) : new ImageSize(400, 300);
            var game = new RenderedGame(nearThings: trial % 7 == 0)
            {
                VerticalFovDegrees = Between(random, 40, 90),
                Lens = lens,
                RainMoves = rains,
                Lighting = new Lighting { RainFraction = rains ? 1 : 0 },
            };
            CalibrationSession session = Run(game, image);
            CalibrationResult result = session.Result ?? throw new InvalidOperationException($"trial {trial}: {session.Fault}");
            ratios.Add(WorstError(game, image, lens, result.Lens) / result.UncertaintyPixels);
        }

        int held = ratios.Count(ratio => ratio <= 1);
        output.WriteLine(
            $"the claim held in {held} of {trials}; error over claim: median {ratios.Order().ElementAt(trials / 2):0.00}, largest "
                + $"{ratios.Max():0.00}"
        );
        Assert.True(held >= 0.95 * trials, $"held in {held} of {trials}, largest ratio {ratios.Max():0.00}");

        // A claim that is far too large would hold too.
        Assert.True(ratios.Order().ElementAt(trials / 2) > 0.2, $"median {ratios.Order().ElementAt(trials / 2):0.00}");
    }

    [Theory]
    [Trait("Category", "Heavy")]
    [InlineData(0.1, 0)]
    [InlineData(0.2, -0.15)]
    [InlineData(-0.12, 0.18)]
    public void Markers_nearer_to_the_position_of_another_are_identified(double offsetX, double offsetY)
    {
        // The coarse grid's neighbours are 60 pixels apart; 0.12 of 400 pixels is 48, 0.2 is 80.
        var image = new ImageSize(400, 300);
        var lens = new RenderLens(1.01, offsetX, offsetY, -0.02, 0);
        var game = new RenderedGame { VerticalFovDegrees = 60, Lens = lens };

        CalibrationSession session = Run(game, image);

        Assert.True(session.Result is not null, session.Fault);
        Assert.InRange(WorstError(game, image, lens, session.Result!.Lens), 0, 0.5);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Lens_is_checked_on_markers_excluded_from_the_fit()
    {
        // After the coarse grid, its seven coded pictures and the fine grid comes the tenth: the one to check by, of which all markers
        // stand 2 cm too high.
        var game = new RenderedGame
        {
            VerticalFovDegrees = 60,
            MarkerShift = new Vector3D(0, 0, 0.02),
            MarkerShiftFromShow = 10,
        };

        CalibrationSession session = Run(game, new ImageSize(400, 300));

        Assert.Null(session.Result);
        Assert.Matches(
            "^The lens misplaces [0-9]+ of [0-9]+ markers that were not used for the fit.*is not where the game reports it",
            session.Fault
        );
    }

    [Fact]
    public void Stretched_picture_is_refused_with_its_cause()
    {
        var game = new RenderedGame { VerticalFovDegrees = 60, RenderedAspect = 4.0 / 3 * 1.02 };

        CalibrationSession session = Run(game, new ImageSize(400, 300));

        Assert.Null(session.Result);
        Assert.Contains("the picture is stretched along one axis", session.Fault, StringComparison.Ordinal);
    }

    [Fact]
    public void Calibration_reports_the_error_of_the_unused_markers()
    {
        CalibrationSession session = Run(new RenderedGame { VerticalFovDegrees = 60 }, new ImageSize(400, 300));

        // 12 x 8 markers.
        Assert.InRange(session.Result!.Validation.Count, 80, 96);
        Assert.InRange(session.Result.Validation.RmsPixels, 0.01, 0.3);
    }

    private static CalibrationSession Run(RenderedGame game, ImageSize image)
    {
        var session = new CalibrationSession(new CalibrationOptions { Image = image }, game.Ports);
        for (int tick = 0; tick < 10_000 && session.Step() == CalibrationPhase.Settling; tick++)
        {
            game.Tick();
        }

        return session;
    }

    /// <summary>
    /// The largest distance between where the injected and the found lens show a point, pixels, over a grid up to the corners.
    /// </summary>
    private static double WorstError(RenderedGame game, ImageSize image, RenderLens injected, Lens found)
    {
        const int steps = 20;
        Pose pose = game.ReadCamera().Pose;
        Camera truth = CameraOf(new Lens(injected.FocalScale, injected.CentreOffsetX, injected.CentreOffsetY, injected.K1, injected.K2));
        Camera model = CameraOf(found);
        double worst = 0;
        for (int i = 0; i <= steps; i++)
        {
            for (int j = 0; j <= steps; j++)
            {
                var pixel = new Vector2D(image.Width * i / (double)steps, image.Height * j / (double)steps);
                worst = Math.Max(worst, (model.Project(truth.Unproject(pixel.X, pixel.Y, 10)).Pixel - pixel).Length);
            }
        }

        return worst;

        Camera CameraOf(Lens lens) => new(pose, new CameraIntrinsics(game.VerticalFovDegrees, image, game.WindowAspect, 0.1, lens));
    }

    private static double Between(Random random, double low, double high) => low + ((high - low) * random.NextDouble());
}
