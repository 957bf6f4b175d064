using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Lanes;

/// <summary>
/// Cases worked out by hand from DeepDriving's rules with lanes 4 m wide, as in TORCS. In its three-lane code t is the distance left
/// of the track's middle; here the offset is measured from the left edge, so offset = 6 - t on three lanes.
/// </summary>
public sealed class IndicatorCalculatorTests
{
    /// <summary>Sums and differences of small decimals: no more than rounding.</summary>
    private const double Rounding = 1e-12;

    private static readonly VehicleAhead[] NoVehicles = [];

    [Fact]
    public void Compute_middle_of_three_lanes_sees_both_neighbours()
    {
        // t = 0: LL = -6, ML = -2, MR = +2, RR = +6; nearest markings 2 m away, on-marking off.
        LaneIndicators at = Compute(lanes: 3, offset: 6);

        AssertValid(-6, at.ToMarkingLL);
        AssertValid(-2, at.ToMarkingML);
        AssertValid(2, at.ToMarkingMR);
        AssertValid(6, at.ToMarkingRR);
        AssertInactive(-7, at.ToMarkingL);
        AssertInactive(3.5, at.ToMarkingM);
        AssertInactive(7, at.ToMarkingR);
        AssertInactive(75, at.DistL);
        AssertInactive(75, at.DistR);
    }

    [Fact]
    public void Compute_right_lane_of_three_has_no_right_neighbour()
    {
        // t = -4: LL = t - 2 = -6, ML = t + 2 = -2, MR = t + 6 = 2, RR off.
        LaneIndicators at = Compute(lanes: 3, offset: 10);

        AssertValid(-6, at.ToMarkingLL);
        AssertValid(-2, at.ToMarkingML);
        AssertValid(2, at.ToMarkingMR);
        AssertInactive(9.5, at.ToMarkingRR);
        AssertInactive(75, at.DistRR);
        AssertValid(IndicatorCalculator.VehicleRange, at.DistLL);
    }

    [Fact]
    public void Compute_left_lane_of_three_has_no_left_neighbour()
    {
        // t = 4.5: ML = t - 6 = -1.5, MR = t - 2 = 2.5, RR = t + 2 = 6.5.
        LaneIndicators at = Compute(lanes: 3, offset: 1.5);

        AssertInactive(-9.5, at.ToMarkingLL);
        AssertValid(-1.5, at.ToMarkingML);
        AssertValid(2.5, at.ToMarkingMR);
        AssertValid(6.5, at.ToMarkingRR);
        AssertInactive(75, at.DistLL);
    }

    [Theory]
    [InlineData(4.0, 0.0)] // t = 2
    [InlineData(3.6, 0.4)] // t = 2.4
    [InlineData(4.3, -0.3)] // t = 1.7
    public void Compute_on_left_inner_marking_of_three_lanes(double offset, double toMiddle)
    {
        // L = t - 6, M = t - 2, R = t + 2, in-lane off within 0.5 m of the marking.
        LaneIndicators at = Compute(lanes: 3, offset);

        AssertValid(toMiddle - 4, at.ToMarkingL);
        AssertValid(toMiddle, at.ToMarkingM);
        AssertValid(toMiddle + 4, at.ToMarkingR);
        AssertInactive(-5.5, at.ToMarkingML);
        AssertInactive(5.5, at.ToMarkingMR);
        AssertInactive(-9.5, at.ToMarkingLL);
        AssertInactive(9.5, at.ToMarkingRR);
        AssertInactive(75, at.DistMM);
    }

    [Fact]
    public void Compute_near_a_marking_gives_both_indicator_systems()
    {
        // t = -1.25 (offset 7.25): middle lane, 0.75 m left of the right inner marking at offset 8.
        LaneIndicators at = Compute(lanes: 3, offset: 7.25);

        AssertValid(-3.25, at.ToMarkingML);
        AssertValid(0.75, at.ToMarkingMR);
        AssertValid(-3.25, at.ToMarkingL);
        AssertValid(0.75, at.ToMarkingM);
        AssertValid(4.75, at.ToMarkingR);
    }

    [Theory]
    [InlineData(6.99, true, false)] // 1.01 m from the marking at 8: in lane only
    [InlineData(7.0, true, true)]
    [InlineData(7.5, true, true)]
    [InlineData(7.51, false, true)] // 0.49 m: on marking only
    public void Compute_activation_overlaps_between_half_and_one_metre(double offset, bool inLane, bool onMarking)
    {
        LaneIndicators at = Compute(lanes: 3, offset);

        Assert.Equal(inLane, at.ToMarkingML.IsValid);
        Assert.Equal(onMarking, at.ToMarkingM.IsValid);
    }

    [Theory]
    [InlineData(12.0, -4.0, 0.0)] // t = -6: on the edge
    [InlineData(13.9, -5.9, -1.9)] // t = -7.9: 1.9 m outside
    [InlineData(11.1, -3.1, 0.9)] // t = -5.1: 0.9 m inside
    public void Compute_on_right_edge_of_three_lanes_has_no_right(double offset, double toMarkingL, double toMarkingM)
    {
        LaneIndicators at = Compute(lanes: 3, offset);

        AssertValid(toMarkingL, at.ToMarkingL);
        AssertValid(toMarkingM, at.ToMarkingM);
        AssertInactive(7, at.ToMarkingR);
        AssertInactive(75, at.DistR);
        AssertValid(IndicatorCalculator.VehicleRange, at.DistL);
    }

    [Fact]
    public void Compute_on_left_edge_of_three_lanes_has_no_left()
    {
        // t = 7: L off, M = t - 6 = 1, R = t - 2 = 5.
        LaneIndicators at = Compute(lanes: 3, offset: -1);

        AssertInactive(-7, at.ToMarkingL);
        AssertValid(1, at.ToMarkingM);
        AssertValid(5, at.ToMarkingR);
        AssertInactive(75, at.DistL);
    }

    [Theory]
    [InlineData(-2.01)]
    [InlineData(14.01)]
    public void Compute_more_than_two_metres_outside_is_inactive(double offset)
    {
        LaneIndicators at = Compute(lanes: 3, offset);

        Assert.Equal(LaneIndicators.Unknown with { Angle = Indicator.Of(0) }, at);
    }

    [Theory]
    [InlineData(2.81, true)] // 1.19 m from the middle marking
    [InlineData(2.79, false)] // 1.21 m
    public void Compute_two_lanes_are_on_marking_within_one_metre_twenty(double offset, bool onMarking)
    {
        Assert.Equal(onMarking, Compute(lanes: 2, offset).ToMarkingM.IsValid);
    }

    [Fact]
    public void Compute_single_lane_has_two_edges()
    {
        // Offset 1.0: 1 m right of the left edge: ML = -1, MR = 3; on the left edge's marking as well: M = -1, R = 3.
        LaneIndicators at = Compute(lanes: 1, offset: 1);

        AssertInactive(-9.5, at.ToMarkingLL);
        AssertValid(-1, at.ToMarkingML);
        AssertValid(3, at.ToMarkingMR);
        AssertInactive(9.5, at.ToMarkingRR);
        AssertInactive(-7, at.ToMarkingL);
        AssertValid(-1, at.ToMarkingM);
        AssertValid(3, at.ToMarkingR);
    }

    [Fact]
    public void Compute_takes_the_nearest_vehicle_ahead_of_each_lane()
    {
        VehicleAhead[] vehicles = [new(0, 40), new(0, 12.5), new(1, -3), new(1, 71), new(2, 69)];

        LaneIndicators at = IndicatorCalculator.Compute(0, 6, new LaneSection(3, 4), vehicles);

        AssertValid(12.5, at.DistLL);
        AssertValid(IndicatorCalculator.VehicleRange, at.DistMM);
        AssertValid(69, at.DistRR);
    }

    [Fact]
    public void Compute_on_marking_uses_vehicles_of_both_adjacent_lanes()
    {
        VehicleAhead[] vehicles = [new(0, 20), new(1, 30)];

        LaneIndicators at = IndicatorCalculator.Compute(0, 4, new LaneSection(3, 4), vehicles);

        AssertValid(20, at.DistL);
        AssertValid(30, at.DistR);
    }

    [Fact]
    public void Compute_wide_lane_scales_the_thresholds()
    {
        // 5.4 m lanes: in lane up to 1.5 · 5.4 / 4 = 2.025 m from the centre at 2.7.
        var section = new LaneSection(2, 5.4);

        Assert.True(IndicatorCalculator.Compute(0, 2.7 + 2.02, section, NoVehicles).ToMarkingML.IsValid);
        Assert.False(IndicatorCalculator.Compute(0, 2.7 + 2.03, section, NoVehicles).ToMarkingML.IsValid);
    }

    [Fact]
    public void TorcsEquivalent_of_wide_lanes_equals_torcs_at_the_same_place()
    {
        VehicleAhead[] vehicles = [new(1, 65)];
        LaneIndicators wide = IndicatorCalculator.Compute(0.1, 1.5 * 5.4, new LaneSection(3, 5.4), vehicles);

        LaneIndicators torcs = TorcsEquivalent.Of(wide, new LaneSection(3, 5.4));

        // Mid-lane of three: the values of t = 0.
        AssertValid(-6, torcs.ToMarkingLL);
        AssertValid(-2, torcs.ToMarkingML);
        AssertValid(2, torcs.ToMarkingMR);
        AssertValid(6, torcs.ToMarkingRR);
        AssertValid(60, torcs.DistMM);
        AssertInactive(75, torcs.DistL);
        AssertValid(0.1, torcs.Angle);
    }

    [Fact]
    public void Normalisation_maps_each_range_to_0_1_through_0_9()
    {
        // The published factors have five digits.
        const double publishedDigits = 2e-4;
        Assert.Equal(0.1, DeepDrivingNormalisation.ToMarkingL(-7), publishedDigits);
        Assert.Equal(0.9, DeepDrivingNormalisation.ToMarkingL(-2.5), publishedDigits);
        Assert.Equal(0.1, DeepDrivingNormalisation.ToMarkingM(-2), publishedDigits);
        Assert.Equal(0.9, DeepDrivingNormalisation.ToMarkingM(3.5), publishedDigits);
        Assert.Equal(0.1, DeepDrivingNormalisation.ToMarkingR(2.5), publishedDigits);
        Assert.Equal(0.9, DeepDrivingNormalisation.ToMarkingR(7), publishedDigits);
        Assert.Equal(0.1, DeepDrivingNormalisation.ToMarkingLL(-9.5), publishedDigits);
        Assert.Equal(0.9, DeepDrivingNormalisation.ToMarkingLL(-4), publishedDigits);
        Assert.Equal(0.1, DeepDrivingNormalisation.ToMarkingML(-5.5), publishedDigits);
        Assert.Equal(0.9, DeepDrivingNormalisation.ToMarkingML(-0.5), publishedDigits);
        Assert.Equal(0.1, DeepDrivingNormalisation.ToMarkingMR(0.5), publishedDigits);
        Assert.Equal(0.9, DeepDrivingNormalisation.ToMarkingMR(5.5), publishedDigits);
        Assert.Equal(0.1, DeepDrivingNormalisation.ToMarkingRR(4), publishedDigits);
        Assert.Equal(0.9, DeepDrivingNormalisation.ToMarkingRR(9.5), publishedDigits);
        Assert.Equal(0.12, DeepDrivingNormalisation.Dist(0), publishedDigits);
        Assert.Equal(0.7516, DeepDrivingNormalisation.Dist(60), publishedDigits);
        Assert.Equal(0.9095, DeepDrivingNormalisation.Dist(75), publishedDigits);
        Assert.Equal(0.5, DeepDrivingNormalisation.Angle(0), publishedDigits);
        Assert.Equal(1, DeepDrivingNormalisation.Angle(2), publishedDigits);
    }

    private static LaneIndicators Compute(int lanes, double offset) =>
        IndicatorCalculator.Compute(0, offset, new LaneSection(lanes, 4), NoVehicles);

    private static void AssertValid(double expected, Indicator actual)
    {
        Assert.True(actual.IsValid);
        Assert.Equal(expected, actual.Value, Rounding);
    }

    private static void AssertInactive(double expected, Indicator actual)
    {
        Assert.False(actual.IsValid);
        Assert.Equal(expected, actual.Value);
    }
}
