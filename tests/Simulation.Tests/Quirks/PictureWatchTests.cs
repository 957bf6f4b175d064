using Harvester.Capture.Faults;
using Harvester.Capture.Harvesting;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>What is drawn over the pictures of a harvest is found while it drives.</summary>
public sealed class PictureWatchTests
{
    private const int Frames = 24;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Plain_pictures_are_left_in_peace() => Assert.Null(WarningOf(new GameQuirks()));

    [Fact]
    [Trait("Category", "Heavy")]
    public void Radar_that_stays_in_frozen_pictures_is_found() =>
        Assert.Contains("lower left", WarningOf(new GameQuirks { ShowsHud = true, HudStaysWhileFrozen = true }), StringComparison.Ordinal);

    [Fact]
    [Trait("Category", "Heavy")]
    public void Display_of_another_program_is_found() =>
        Assert.Contains("upper right", WarningOf(new GameQuirks { ShowsForeignDisplay = true }), StringComparison.Ordinal);

    private static string? WarningOf(GameQuirks quirks)
    {
        using var harvest = new QuirkHarvest(
            quirks,
            new HarvestOptions { MaxFrames = Frames, RateHz = 1 },
            static game => game.Ports.Hud!.Hide()
        );
        string? warning = harvest.Session.Warnings.SingleOrDefault(each => each.Code == FaultCode.PicturesSpoiled)?.Message;
        Assert.Equal(warning, harvest.Sink.End!.PictureWarning);
        return warning;
    }
}
