using Harvester.Capture.Harvesting;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Calibration;

/// <summary>A harvest holds its camera model against markers before it records anything.</summary>
public sealed class CalibrationCheckTests
{
    private static readonly HarvestOptions Options = new() { Image = new ImageSize(800, 600), MaxFrames = 1, ProbeLag = false };
    private static readonly Lens Right = new(1.008, 0, 0, -0.02, 0);

    [Fact]
    public void Step_with_the_right_lens_checks_and_then_records()
    {
        var phases = new List<HarvestPhase>();

        HarvestOutcome outcome = Harvest(Game(), Options with { Lens = Right }, phases);

        Assert.Contains(HarvestPhase.CheckingCalibration, phases);
        Assert.Equal(HarvestPhase.Stopped, phases[^1]);
        Assert.Equal(1, outcome.Frames);
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
        Assert.Equal(new HarvestOutcome(true, 1, null), Harvest(Game(), Options with { MaxCalibrationErrorPixels = 50 }, []));
        Assert.Equal(new HarvestOutcome(true, 1, null), Harvest(Game(), Options with { MaxCalibrationErrorPixels = null }, []));
    }

    [Theory]
    [InlineData(64, 48)]
    [InlineData(160, 120)]
    [InlineData(1280, 720)]
    public void Step_in_images_of_other_sizes_checks_too(int width, int height) =>
        Assert.Equal(new HarvestOutcome(true, 1, null), Harvest(Game(), Options with { Image = new ImageSize(width, height), Lens = Right }, []));

    [Fact]
    public void Step_with_the_view_blocked_refuses()
    {
        var game = new RenderedGame { HidesMarkers = true };

        Assert.Matches("only 0 of 20 markers are seen", Harvest(game, Options, []).Fault);
    }

    private static RenderedGame Game() =>
        new() { VerticalFovDegrees = 60, Lens = new RenderLens(1.008, 0, 0, -0.02, 0) };

    private static HarvestOutcome Harvest(RenderedGame game, HarvestOptions options, List<HarvestPhase> phases)
    {
        using var sink = new CountingSink();
        using var session = new HarvestSession(options, game.Ports, sink);
        for (int tick = 0; tick < 1_000 && !session.Status.IsOver; tick++)
        {
            phases.Add(session.Step().Phase);
            game.Tick();
        }

        return new HarvestOutcome(sink.IsOpened, sink.Frames, session.Fault);
    }

    private sealed record HarvestOutcome(bool IsOpened, int Frames, string? Fault);

    private sealed class CountingSink : IFrameSink
    {
        public bool IsOpened { get; private set; }

        public int Frames { get; private set; }

        public string? Fault => null;

        public int FirstFrame => 0;

        public int FirstObjectId => 1;

        public void Open(SessionStart start) => IsOpened = true;

        public bool TryEnqueue(CapturedFrame frame)
        {
            Frames++;
            return true;
        }

        public void Close(SessionEnd end)
        {
        }

        public void Dispose()
        {
        }
    }
}
