using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;

namespace Harvester.Capture.Tests.Harvesting;

public sealed class FreezeReportTests
{
    private static readonly FreezeFinding Paused = new(FreezeMethod.Paused, true, 2)
    {
        MovesCamera = true,
        HoldsEnvironment = true,
        PictureChange = 0.5,
    };
    private static readonly FreezeFinding Scaled = Paused with { Method = FreezeMethod.TimeScale };

    public static TheoryData<FreezeFinding, FreezeFinding, FreezeMethod> Pairs =>
        new()
        {
            { Paused, Scaled, FreezeMethod.Paused },
            { Paused with { SettleTicks = null }, Scaled with { MovesCamera = false, HoldsEnvironment = false }, FreezeMethod.TimeScale },
            { Paused with { MovesCamera = false }, Scaled with { HoldsEnvironment = false }, FreezeMethod.TimeScale },
            { Paused with { HoldsEnvironment = false }, Scaled with { PictureChange = 3 }, FreezeMethod.TimeScale },
            { Paused with { PictureChange = 1.1 }, Scaled with { SettleTicks = 5 }, FreezeMethod.TimeScale },
            { Paused with { PictureChange = 0.9 }, Scaled with { SettleTicks = 5 }, FreezeMethod.Paused },
            { Paused with { PictureChange = 0.09 }, Scaled with { PictureChange = 0.01 }, FreezeMethod.Paused },
            { Paused with { PictureChange = null }, Scaled with { SettleTicks = 5 }, FreezeMethod.Paused },
            { Paused, Scaled with { SettleTicks = 1 }, FreezeMethod.TimeScale },
            { Paused with { MovesCamera = null }, Scaled with { MovesCamera = null, SettleTicks = 1 }, FreezeMethod.TimeScale },
        };

    [Theory]
    [MemberData(nameof(Pairs))]
    public void Best_freeze_method_wins_the_first_criterion_that_differs(
        FreezeFinding paused,
        FreezeFinding scaled,
        FreezeMethod expected
    ) => Assert.Equal(expected, FreezeReport.Of([paused, scaled]).Method);

    [Fact]
    public void Findings_without_movement_are_not_conclusive()
    {
        Assert.True(FreezeReport.Of([Paused, Scaled]).IsConclusive);
        Assert.False(FreezeReport.Of([Paused, Scaled with { SawMovement = false }]).IsConclusive);
    }

    [Fact]
    public void Text_describes_each_freeze_method_and_the_choice() =>
        Assert.Equal(
            "Paused: the world never stood still; TimeScale: the world stood still after 2 ticks (nothing was moving "
                + "before), weather or time "
                + "of day changed, "
                + "the camera could not be moved, the image changed by 0.50 of 255; TimeScale is used.",
            FreezeReport
                .Of([
                    new FreezeFinding(FreezeMethod.Paused, true, null),
                    Scaled with
                    {
                        SawMovement = false,
                        HoldsEnvironment = false,
                        MovesCamera = false,
                    },
                ])
                .ToString()
        );

    [Fact]
    public void Report_without_findings_is_refused() => Assert.Throws<ArgumentException>(() => FreezeReport.Of([]));
}
