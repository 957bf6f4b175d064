using Harvester.Datasets.Validation;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>Lanes that cannot be.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class LanesCheckTests(SimulatedSession session)
{
    private LanesLabel Good =>
        session.Open().ReadLabels().Select(label => label.Lanes!).First(lanes => lanes.Indicators.ToMarkingML.IsValid);

    [Fact]
    public void Lanes_of_a_harvest_have_no_problems() =>
        Assert.All(session.Open().ReadLabels(), label => Assert.Empty(LanesCheck.Problems(label.Lanes!)));

    [Fact]
    public void Problems_include_an_indicator_out_of_range() =>
        AssertProblem(
            Good with
            {
                Indicators = Good.Indicators with { ToMarkingML = Indicator.Of(99) },
            },
            "lanes.indicators.toMarkingML is 99; it must be"
        );

    [Fact]
    public void Problems_include_a_vehicle_beyond_the_range() =>
        AssertProblem(
            Good with
            {
                IndicatorsAtCar = Good.IndicatorsAtCar with { DistMM = Indicator.Of(80) },
            },
            "lanes.atCar.indicators.distMM is 80; it must be 0 to 70."
        );

    [Fact]
    public void Problems_include_an_inactive_indicator_with_a_value() =>
        AssertProblem(
            Good with
            {
                TorcsEquivalent = Good.TorcsEquivalent with { DistR = new Indicator(12, false) },
            },
            "lanes.torcsEquivalent.distR is 12, but an invalid indicator must have 75."
        );

    [Fact]
    public void Problems_include_a_lane_that_does_not_exist() =>
        AssertProblem(Good with { LaneCount = 2, Lane = 2 }, "lanes.lane is 2, but lanes.laneCount is 2.");

    private static void AssertProblem(LanesLabel lanes, string message) =>
        Assert.StartsWith(message, Assert.Single(LanesCheck.Problems(lanes)), StringComparison.Ordinal);
}
