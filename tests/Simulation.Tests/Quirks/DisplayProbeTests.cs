using Harvester.Capture.Faults;
using Harvester.Capture.Harvesting;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>A harvest finds out before its first frame whether the game's display can be hidden while it is frozen.</summary>
public sealed class DisplayProbeTests
{
    [Fact]
    [Trait("Category", "Heavy")]
    public void Game_without_a_display_shows_no_difference() => AssertFinding(new GameQuirks(), DisplayState.NotSeen, null);

    [Fact]
    [Trait("Category", "Heavy")]
    public void Display_that_can_be_hidden_is_found_with_its_region() =>
        AssertFinding(new GameQuirks { ShowsHud = true }, DisplayState.Hidden, "lower left");

    [Fact]
    public void Display_of_late_and_noisy_pictures_is_found() =>
        AssertFinding(
            new GameQuirks
            {
                ShowsHud = true,
                PictureLagTicks = 2,
                PictureNoiseLevels = 5,
            },
            DisplayState.Hidden,
            "lower left"
        );

    [Fact]
    public void Display_that_stays_while_the_game_is_frozen_is_found() =>
        AssertFinding(new GameQuirks { ShowsHud = true, HudStaysWhileFrozen = true }, DisplayState.Stays, null);

    private static void AssertFinding(GameQuirks quirks, DisplayState state, string? region)
    {
        using var harvest = new QuirkHarvest(quirks, new HarvestOptions { MaxFrames = 2, ChecksDisplay = true });
        DisplayFinding found = harvest.Sink.Start!.Display!;

        Assert.Equal(new DisplayFinding(state, null), found with { Region = null });
        Assert.Equal(region, found.Region?.Split(',')[0]);
        Assert.Equal(state == DisplayState.Stays, harvest.Session.Warnings.Any(warning => warning.Code == FaultCode.DisplayStays));
    }
}
