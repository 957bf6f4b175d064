using Harvester.Capture.Faults;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>A harvest finds out before its first frame whether the game's display can be hidden while it is frozen.</summary>
public sealed class DisplayProbeTests
{
    private const double TicksPerSecond = 10;

    [Fact]
    public void Game_without_a_display_shows_no_difference() => AssertFinding(new GameQuirks(), DisplayState.NotSeen, null);

    [Fact]
    public void Display_that_can_be_hidden_is_found_with_its_region() =>
        AssertFinding(new GameQuirks { ShowsHud = true }, DisplayState.Hidden, "lower left");

    [Fact]
    public void Display_of_late_and_noisy_pictures_is_found() => AssertFinding(
        new GameQuirks { ShowsHud = true, PictureLagTicks = 2, PictureNoiseLevels = 5 }, DisplayState.Hidden, "lower left");

    [Fact]
    public void Display_that_stays_while_the_game_is_frozen_is_found() =>
        AssertFinding(new GameQuirks { ShowsHud = true, HudStaysWhileFrozen = true }, DisplayState.Stays, null);

    private static void AssertFinding(GameQuirks quirks, DisplayState state, string? region)
    {
        var game = new SimulatedGame(new SimulationOptions
        {
            Seed = 61,
            WindowAspect = 4.0 / 3,
            IsWarm = true,
            Detail = Detail.Plain,
            TimeOfDay = TimeSpan.FromHours(12),
            Quirks = quirks,
        });
        var sink = new MemorySink { KeepsFrames = false };
        var options = new HarvestOptions
        {
            Image = new ImageSize(320, 240),
            MaxFrames = 2,
            ProbeLag = false,
            MaxCalibrationErrorPixels = null,
            ChecksDisplay = true,
        };
        using var session = new HarvestSession(options, game.Ports, sink);
        while (!session.Step().IsOver)
        {
            game.Tick(1 / TicksPerSecond);
        }

        Assert.Null(session.Fault);
        Assert.Equal(new DisplayFinding(state, null), sink.Start!.Display! with { Region = null });
        Assert.Equal(region, sink.Start.Display.Region?.Split(',')[0]);
        Assert.Equal(state == DisplayState.Stays, session.Warnings.Any(warning => warning.Code == FaultCode.DisplayStays));
    }
}
