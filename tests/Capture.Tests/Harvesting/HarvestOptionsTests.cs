using Harvester.Capture.Harvesting;

namespace Harvester.Capture.Tests.Harvesting;

public sealed class HarvestOptionsTests
{
    public static TheoryData<string, Func<HarvestOptions, HarvestOptions>> Impossible =>
        new()
        {
            { "RateHz", options => options with { RateHz = 0 } },
            { "RateHz", options => options with { RateHz = double.NaN } },
            { "RateHz", options => options with { RateHz = double.PositiveInfinity } },
            { "RangeMetres", options => options with { RangeMetres = -1 } },
            { "IgnoreRangeMetres", options => options with { IgnoreRangeMetres = -1 } },
            { "MinBoxAreaPixels", options => options with { MinBoxAreaPixels = -1 } },
            { "MinBoxSidePixels", options => options with { MinBoxSidePixels = double.NaN } },
            { "MaxOccludedFraction", options => options with { MaxOccludedFraction = 1.01 } },
            { "OcclusionSamples", options => options with { OcclusionSamples = 0 } },
            { "MaxFrames", options => options with { MaxFrames = 0 } },
            { "MaxPictureLagTicks", options => options with { MaxPictureLagTicks = -1 } },
            { "MaxSettleTicks", options => options with { MaxSettleTicks = 0 } },
            { "StillToleranceMetres", options => options with { StillToleranceMetres = double.NaN } },
            { "TickBudgetMilliseconds", options => options with { TickBudgetMilliseconds = 0 } },
            { "QueueCapacity", options => options with { QueueCapacity = 0 } },
        };

    [Theory]
    [MemberData(nameof(Impossible))]
    public void Value_out_of_range_is_refused_by_name(string name, Func<HarvestOptions, HarvestOptions> change)
    {
        ArgumentOutOfRangeException refusal = Assert.Throws<ArgumentOutOfRangeException>(() => change(new HarvestOptions()));

        Assert.Equal(name, refusal.ParamName);
        Assert.StartsWith(name + " must be", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Absent_frame_limit_and_values_at_the_limits_are_accepted()
    {
        HarvestOptions options = new()
        {
            MaxFrames = null,
            MaxOccludedFraction = 1,
            MinBoxAreaPixels = 0,
            MaxPictureLagTicks = 0,
            MaxSettleTicks = 1,
        };

        Assert.Null(options.MaxFrames);
    }
}
