using Harvester.Capture.Faults;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>What is drawn over the pictures of a harvest is found while it drives.</summary>
public sealed class PictureWatchTests
{
    private const double TicksPerSecond = 10;
    private const int Frames = 24;

    [Fact]
    public void Plain_pictures_are_left_in_peace() => Assert.Null(WarningOf(new GameQuirks()));

    [Fact]
    public void Radar_that_stays_in_frozen_pictures_is_found() => Assert.Contains(
        "lower left", WarningOf(new GameQuirks { ShowsHud = true, HudStaysWhileFrozen = true }), StringComparison.Ordinal);

    [Fact]
    public void Display_of_another_program_is_found() => Assert.Contains(
        "upper right", WarningOf(new GameQuirks { ShowsForeignDisplay = true }), StringComparison.Ordinal);

    private static string? WarningOf(GameQuirks quirks)
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
            MaxFrames = Frames,
            RateHz = 1,
            ProbeLag = false,
            MaxCalibrationErrorPixels = null,
        };
        using var session = new HarvestSession(options, game.Ports, sink);
        game.Ports.Hud!.Hide();
        while (!session.Step().IsOver)
        {
            game.Tick(1 / TicksPerSecond);
        }

        Assert.Null(session.Fault);
        string? warning = session.Warnings.SingleOrDefault(each => each.Code == FaultCode.PicturesSpoiled)?.Message;
        Assert.Equal(warning, sink.End!.PictureWarning);
        return warning;
    }
}
