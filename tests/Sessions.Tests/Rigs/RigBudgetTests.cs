using Harvester.Sessions.Rigs;

namespace Harvester.Sessions.Tests.Rigs;

public sealed class RigBudgetTests
{
    private const double Rounding = 1e-9;

    // 1,000,000 pixels, and 1,000 columns of 30 beams.
    private static readonly Rig Million = RigParser.Parse(
        """
        {"name":"million","cameras":[{"name":"front","position":[0,2,1],"verticalFovDegrees":50,"width":1000,"height":1000}],
        "lidars":[{"name":"top","position":[0,0,2],"columns":1000,"beamsDegrees":[1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,
        21,22,23,24,25,26,27,28,29,30]}]}
        """
    );

    [Theory]
    // The picture takes 1e6 / 5e6 s, labels 0.02 s, rays 3e4 / 3e5 s; a mask 1e6 / 1.5e7 s more, and depth maps 1e6 / 3e6 s.
    [InlineData(false, false, 0.32)]
    [InlineData(true, false, 0.32 + (1 / 15.0))]
    [InlineData(true, true, 0.32 + (1 / 15.0) + (1 / 3.0))]
    public void Masks_and_depth_count(bool masks, bool depth, double seconds) =>
        Assert.InRange(RigBudget.SecondsPerMoment(Million, masks, depth) - seconds, -Rounding, Rounding);

    [Fact]
    public void Rays_are_those_of_all_sensors() =>
        Assert.InRange(RigBudget.RaysPerMoment(Million, masks: true, depth: true) - (30_000 + 50_000), -Rounding, Rounding);

    [Fact]
    public void Longer_moment_is_refused_with_its_estimate()
    {
        Assert.Null(RigBudget.ProblemOf(Million, RigBudget.MaxSeconds));
        Assert.Equal(
            "A moment of the rig 'million' takes about 61 s; at most 60 s are allowed. Give it fewer rays or smaller images.",
            RigBudget.ProblemOf(Million, 61)
        );
    }
}
