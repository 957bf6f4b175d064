using Harvester.Capture.Calibration;
using Harvester.Geometry;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Rendering;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Calibration;

/// <summary>Calibration by pictures of the renderer, which knows nothing of Geometry's projection.</summary>
public sealed class CalibrationSessionTests(ITestOutputHelper output)
{
    // The required accuracy of a calibrated camera, pixels over the whole image.
    private const double MaxRms = 0.3;
    private const double MaxError = 1;
    private static readonly RenderLens Injected = new(1.008, 0, 0, -0.02, 0);

    [Theory]
    [InlineData(50, 2)]
    [InlineData(90, 10)]
    [Trait("Category", "Heavy")]
    public void Step_until_done_finds_an_injected_lens(double fov, double minErrorBefore) => FindInjected(800, 600, fov, minErrorBefore);

    [Theory]
    [InlineData(50, 10)]
    [InlineData(90, 10)]
    [Trait("Category", "Heavy")]
    public void Step_until_done_finds_an_injected_lens_in_full_hd(double fov, double minErrorBefore) =>
        FindInjected(1920, 1080, fov, minErrorBefore);

    [Theory]
    [InlineData(0)]
    [InlineData(3)]
    [Trait("Category", "Heavy")]
    public void Step_with_picture_lag_and_posts_in_view_finds_a_shifted_lens(int lag) => FindShifted(lag);

    [Theory]
    [Trait("Category", "Heavy")]
    [InlineData(1)]
    [InlineData(2)]
    public void Step_with_other_picture_lags_finds_a_shifted_lens(int lag) => FindShifted(lag);

    [Fact]
    public void Step_finds_the_lens_in_a_window_of_another_aspect()
    {
        var image = new ImageSize(400, 300);
        var game = new RenderedGame
        {
            Lens = Injected,
            WindowAspect = 16.0 / 9,
            VerticalFovDegrees = 60,
        };

        CalibrationResult result = Calibrate(game, image);

        (double rms, double max) = ErrorOverImage(game, image, Injected, result.Lens);
        Assert.True(rms <= MaxRms && max <= MaxError, $"{rms:F3} px RMS, {max:F3} px at most after");
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Step_finds_the_lens_in_rain()
    {
        var image = new ImageSize(400, 300);
        var game = new RenderedGame
        {
            Lens = Injected,
            VerticalFovDegrees = 60,
            RainMoves = true,
            Lighting = new Lighting { RainFraction = 1 },
        };

        CalibrationResult result = Calibrate(game, image);

        (double rms, double max) = ErrorOverImage(game, image, Injected, result.Lens);
        Assert.True(rms <= MaxRms && max <= MaxError, $"{rms:F3} px RMS, {max:F3} px at most after");
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Step_of_a_pinhole_finds_a_pinhole()
    {
        var image = new ImageSize(400, 300);
        var game = new RenderedGame();

        CalibrationResult result = Calibrate(game, image);

        Assert.InRange(ErrorOverImage(game, image, RenderLens.None, result.Lens).Max, 0, 0.3);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Step_leaves_the_game_running_without_markers_at_the_end()
    {
        var game = new RenderedGame();

        Calibrate(game, new ImageSize(400, 300));

        Assert.False(game.IsFrozen);
        Assert.False(game.ShowsMarkers);
    }

    [Theory]
    [InlineData(0.01, null, "camera moved|stand still")]
    [InlineData(0, "covered", "covered")]
    public void Step_without_a_static_open_view_fails_with_a_message(double creep, string? refusal, string message)
    {
        var game = new RenderedGame { Creep = creep, Refusal = refusal };
        using var session = new CalibrationSession(
            new CalibrationOptions { Image = new ImageSize(80, 60), MarkerRadiusPixels = 1 },
            game.Ports
        );

        Run(session, game);

        Assert.Equal(CalibrationPhase.Failed, session.Phase);
        Assert.Null(session.Result);
        Assert.Matches(message, session.Fault);
        Assert.False(game.IsFrozen);
        Assert.False(game.ShowsMarkers);
    }

    [Fact]
    public void Dispose_in_the_middle_resumes_the_game()
    {
        var game = new RenderedGame();
        var session = new CalibrationSession(new CalibrationOptions { Image = new ImageSize(400, 300) }, game.Ports);
        while (!game.ShowsMarkers)
        {
            session.Step();
            game.Tick();
        }

        session.Dispose();

        Assert.Equal(CalibrationPhase.Failed, session.Step());
        Assert.False(game.IsFrozen);
        Assert.False(game.ShowsMarkers);
    }

    [Fact]
    public void Game_that_draws_no_markers_is_refused() =>
        Assert.Throws<ArgumentException>(() =>
            new CalibrationSession(new CalibrationOptions(), new RenderedGame().Ports with { Markers = null })
        );

    private static void FindShifted(int lag)
    {
        var image = new ImageSize(800, 600);
        var lens = new RenderLens(0.995, 0.004, -0.003, 0.015, -0.002);
        var game = new RenderedGame(nearThings: true)
        {
            Lens = lens,
            PictureLag = lag,
            VerticalFovDegrees = 60,
        };

        CalibrationResult result = Calibrate(game, image);

        (double rms, double max) = ErrorOverImage(game, image, lens, result.Lens);
        Assert.True(rms <= MaxRms && max <= MaxError, $"{rms:F3} px RMS, {max:F3} px at most after");
    }

    private void FindInjected(int width, int height, double fov, double minErrorBefore)
    {
        var image = new ImageSize(width, height);
        var game = new RenderedGame
        {
            Lens = Injected,
            VerticalFovDegrees = fov,
            WindowAspect = image.Aspect,
        };

        CalibrationResult result = Calibrate(game, image);

        (double rmsBefore, double maxBefore) = ErrorOverImage(game, image, Injected, Lens.Ideal);
        (double rms, double max) = ErrorOverImage(game, image, Injected, result.Lens);
        output.WriteLine(
            $"{width}x{height}, {fov} degrees: {rmsBefore:F2} px RMS and {maxBefore:F2} px at most before, {rms:F3} and {max:F3} after; "
                + $"reported {result}"
        );
        Assert.True(maxBefore >= minErrorBefore, $"{maxBefore:F2} px at most before");
        Assert.True(rms <= MaxRms && max <= MaxError, $"{rms:F3} px RMS, {max:F3} px at most after");
        Assert.True(result.After.RmsPixels <= MaxRms && result.After.MaxPixels <= MaxError, $"{result.After} reported");
        Assert.True(result.Before.MaxPixels > maxBefore / 2, $"{result.Before.MaxPixels:F2} px reported before");
    }

    private static CalibrationResult Calibrate(RenderedGame game, ImageSize image)
    {
        using var session = new CalibrationSession(new CalibrationOptions { Image = image }, game.Ports);
        Run(session, game);
        Assert.True(session.Result is not null, session.Fault);
        return session.Result!;
    }

    private static void Run(CalibrationSession session, RenderedGame game)
    {
        for (int tick = 0; tick < 10_000 && session.Step() == CalibrationPhase.Settling; tick++)
        {
            game.Tick();
        }
    }

    /// <summary>Maximum distance between the pixels of the injected and the found camera, over a grid up to the image's corners.</summary>
    private static (double Rms, double Max) ErrorOverImage(RenderedGame game, ImageSize image, RenderLens injected, Lens found)
    {
        const int steps = 40;
        Pose pose = game.ReadCamera().Pose;
        Camera truth = CameraOf(new Lens(injected.FocalScale, injected.CentreOffsetX, injected.CentreOffsetY, injected.K1, injected.K2));
        Camera model = CameraOf(found);
        var sightings = new List<Sighting>();
        for (int i = 0; i <= steps; i++)
        {
            for (int j = 0; j <= steps; j++)
            {
                var pixel = new Vector2D(image.Width * i / (double)steps, image.Height * j / (double)steps);
                sightings.Add(new Sighting(pose, truth.Unproject(pixel.X, pixel.Y, 10), pixel));
            }
        }

        var error = ReprojectionError.Of(model.Intrinsics, sightings);
        return (error.RmsPixels, error.MaxPixels);

        Camera CameraOf(Lens lens) => new(pose, new CameraIntrinsics(game.VerticalFovDegrees, image, game.WindowAspect, 0.1, lens));
    }
}
