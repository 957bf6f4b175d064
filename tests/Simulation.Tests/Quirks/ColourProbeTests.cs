using Harvester.Capture.Faults;
using Harvester.Capture.Harvesting;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>A harvest finds out before its first frame whether pictures show the colours of the game.</summary>
public sealed class ColourProbeTests
{
    [Fact]
    [Trait("Category", "Heavy")]
    public void Kept_colours_cause_no_warning() => Assert.Null(WarningOf(new GameQuirks(), ColourState.Kept));

    [Fact]
    public void Noise_and_lag_cause_no_warning() =>
        Assert.Null(WarningOf(new GameQuirks { PictureNoiseLevels = 5, PictureLagTicks = 2 }, ColourState.Kept));

    [Fact]
    [Trait("Category", "Heavy")]
    public void Overexposed_pictures_are_found() =>
        Assert.Contains(
            "a grey of 192 comes back as 255",
            WarningOf(new GameQuirks { PictureGain = 1.6 }, ColourState.Clipped),
            StringComparison.Ordinal
        );

    // 255 (192 / 255)^0.7 = 209 and 255 (128 / 255)^0.7 = 157; 255 (192 / 255)^1.3 = 176 and 255 (128 / 255)^1.3 = 104.
    [Theory]
    [InlineData(0.7, "209 and 157")]
    [InlineData(1.3, "176 and 104")]
    [Trait("Category", "Heavy")]
    public void Washed_out_and_darkened_pictures_are_found(double exponent, string levels) =>
        Assert.Contains(levels, WarningOf(new GameQuirks { PictureExponent = exponent }, ColourState.Changed), StringComparison.Ordinal);

    [Fact]
    public void Picture_of_another_window_gives_no_finding() =>
        Assert.Null(WarningOf(new GameQuirks { ShowsOtherWindow = true }, expected: null));

    private static string? WarningOf(GameQuirks quirks, ColourState? expected)
    {
        using var harvest = new QuirkHarvest(quirks, new HarvestOptions { MaxFrames = 2, ChecksDisplay = true });

        Assert.Equal(expected, harvest.Sink.Start!.Colours?.State);
        Assert.Empty(harvest.Game.Layers.Card);
        return harvest.Session.Warnings.SingleOrDefault(warning => warning.Code == FaultCode.ColoursChanged)?.Message;
    }
}
