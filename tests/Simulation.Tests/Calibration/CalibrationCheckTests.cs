using Harvester.Capture.Harvesting;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Calibration;

/// <summary>A harvest checks its camera model by markers before it records anything.</summary>
public sealed class CalibrationCheckTests
{
    private static readonly HarvestOptions Options = new()
    {
        Image = new ImageSize(400, 300),
        MaxFrames = 1,
        ProbeLag = false,
    };
    private static readonly Lens Right = new(1.008, 0, 0, -0.02, 0);

    [Fact]
    public void Step_with_the_right_lens_checks_and_then_records()
    {
        var phases = new List<HarvestPhase>();

        HarvestOutcome outcome = Harvest(Game(), Options with { Lens = Right }, phases);

        Assert.Contains(HarvestPhase.CheckingCalibration, phases);
        Assert.Equal(HarvestPhase.Stopped, phases[^1]);
        AssertRecorded(outcome, isChecked: true);
        // Far less than the pixel that is allowed: this lens is the game's own.
        Assert.InRange(outcome.CameraErrorPixels!.Value, 0, 0.5);
    }

    [Fact]
    public void Step_without_the_lens_refuses_before_anything_is_opened()
    {
        var game = Game();

        HarvestOutcome outcome = Harvest(game, Options, []);

        Assert.False(outcome.IsOpened);
        Assert.Matches("^The camera model is off by [0-9.]+ px, more than the 1.0 px allowed", outcome.Fault);
        Assert.False(game.IsFrozen);
        Assert.False(game.ShowsMarkers);
    }

    [Fact]
    public void Step_without_the_lens_records_when_the_user_allows_the_error()
    {
        AssertRecorded(Harvest(Game(), Options with { MaxCalibrationErrorPixels = 50 }, []), isChecked: true);
        AssertRecorded(Harvest(Game(), Options with { MaxCalibrationErrorPixels = null }, []), isChecked: false);
    }

    [Theory]
    [InlineData(64, 48)]
    [InlineData(160, 120)]
    [InlineData(1280, 720)]
    public void Step_in_images_of_other_sizes_checks_too(int width, int height) =>
        AssertRecorded(Harvest(Game(), Options with { Image = new ImageSize(width, height), Lens = Right }, []), isChecked: true);

    [Fact]
    [Trait("Category", "Heavy")]
    public void Step_with_hidden_markers_fails_with_their_number()
    {
        var game = new RenderedGame { HiddenMarkers = 15 };

        HarvestOutcome outcome = Harvest(game, Options, []);

        Assert.False(outcome.IsOpened);
        Assert.Matches("too few markers are visible, 5 of 20", outcome.Fault);
    }

    [Theory]
    [InlineData(5)]
    [InlineData(8)]
    [InlineData(40)]
    [InlineData(60)]
    public void Step_with_excessive_picture_lag_fails_and_reports_the_lag(int lag)
    {
        var game = new RenderedGame { PictureLag = lag };

        HarvestOutcome outcome = Harvest(game, Options with { Image = new ImageSize(160, 120) }, []);

        Assert.Equal($"The image is {lag} ticks behind the game; the harvest allows 4.", outcome.Fault);
        Assert.False(outcome.IsOpened);
        Assert.False(game.IsFrozen);
        Assert.False(game.ShowsMarkers);
    }

    [Fact]
    public void Step_with_the_largest_allowed_lag_records() =>
        AssertRecorded(
            Harvest(new RenderedGame { PictureLag = 7 }, Options with { Image = new ImageSize(160, 120), MaxPictureLagTicks = 7 }, []),
            isChecked: true
        );

    [Fact]
    public void Step_without_visible_markers_warns_and_records_unchecked()
    {
        HarvestOutcome outcome = Harvest(new RenderedGame { HiddenMarkers = int.MaxValue }, Options, []);

        Assert.True(outcome is { IsOpened: true, Frames: 1, Fault: null, CameraErrorPixels: null }, outcome.ToString());
        Assert.Matches("not checked: none of 20 markers was visible.*The picture lag was not checked", outcome.Warning);
    }

    private static RenderedGame Game() => new() { VerticalFovDegrees = 60, Lens = new RenderLens(1.008, 0, 0, -0.02, 0) };

    private static HarvestOutcome Harvest(RenderedGame game, HarvestOptions options, List<HarvestPhase> phases)
    {
        using var sink = new CountingSink();
        using var session = new HarvestSession(options, game.Ports, sink);
        for (int tick = 0; tick < 1_000 && !session.Status.IsOver; tick++)
        {
            phases.Add(session.Step().Phase);
            game.Tick();
        }

        string? warning = session.Warnings.Count > 0 ? string.Join(" ", session.Warnings.Select(fault => fault.Message)) : null;
        return new HarvestOutcome(sink.Start is not null, sink.Frames, session.Fault, warning, sink.Start?.CameraErrorPixels);
    }

    private static void AssertRecorded(HarvestOutcome outcome, bool isChecked)
    {
        Assert.True(outcome is { IsOpened: true, Frames: 1, Fault: null, Warning: null }, outcome.ToString());
        Assert.Equal(isChecked, outcome.CameraErrorPixels is not null);
    }

    private sealed record HarvestOutcome(bool IsOpened, int Frames, string? Fault, string? Warning, double? CameraErrorPixels);

    private sealed class CountingSink : IFrameSink
    {
        public SessionStart? Start { get; private set; }

        public int Frames { get; private set; }

        public string? Fault => null;

        public int FirstFrame => 0;

        public int FirstObjectId => 1;

        public int FirstEventId => 1;

        public void Open(SessionStart start) => Start = start;

        public bool TryEnqueue(CapturedFrame frame)
        {
            Frames++;
            return true;
        }

        public void Close(SessionEnd end) { }

        public void Dispose() { }
    }
}
