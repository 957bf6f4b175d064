using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry.Lanes;

namespace Harvester.Sessions.Labels;

/// <summary>
/// The thirteen indicators as a row of numbers, in the order of DeepDriving's training data: angle; toMarking L, M, R; dist L, R;
/// toMarking LL, ML, MR, RR; dist LL, MM, RR.
/// </summary>
public static class IndicatorOrder
{
    /// <summary>How many there are.</summary>
    public const int Count = 13;

    /// <summary>Far beyond what an indicator can be, metres or radians: what is more is no reading of a road.</summary>
    private const double MaxValue = 1000;

    /// <summary>Their names, in order.</summary>
    public static IReadOnlyList<string> Names { get; } =
    [
        "angle", "toMarking_L", "toMarking_M", "toMarking_R", "dist_L", "dist_R",
        "toMarking_LL", "toMarking_ML", "toMarking_MR", "toMarking_RR", "dist_LL", "dist_MM", "dist_RR",
    ];

    /// <summary>The values in order; an indicator that says nothing gives its inactive value.</summary>
    public static double[] Values(LaneIndicators indicators)
    {
        if (indicators is null)
        {
            throw new ArgumentNullException(nameof(indicators));
        }

        return
        [
            indicators.Angle.Value,
            indicators.ToMarkingL.Value,
            indicators.ToMarkingM.Value,
            indicators.ToMarkingR.Value,
            indicators.DistL.Value,
            indicators.DistR.Value,
            indicators.ToMarkingLL.Value,
            indicators.ToMarkingML.Value,
            indicators.ToMarkingMR.Value,
            indicators.ToMarkingRR.Value,
            indicators.DistLL.Value,
            indicators.DistMM.Value,
            indicators.DistRR.Value,
        ];
    }

    /// <summary>
    /// Indicators from values as a network gives them. It gives no flags and hits no inactive value exactly, so an indicator counts as
    /// inactive past the limit half-way between the greatest value that the place on the road allows and its inactive value.
    /// </summary>
    /// <exception cref="ArgumentException">There are not thirteen values, or one is beyond any road's.</exception>
    public static LaneIndicators FromValues(IReadOnlyList<double> values)
    {
        if (values is null || values.Count != Count)
        {
            throw new ArgumentException("There are thirteen indicators.", nameof(values));
        }

        if (!values.All(static value => Math.Abs(value) <= MaxValue))
        {
            throw new ArgumentException(FormattableString.Invariant($"An indicator is beyond -{MaxValue} to {MaxValue}."), nameof(values));
        }

        return new LaneIndicators
        {
            Angle = Indicator.Of(values[0]),
            ToMarkingL = NotBelow(values[1], -6.5, IndicatorRanges.ToMarkingL),
            ToMarkingM = NotAbove(values[2], 2.75, IndicatorRanges.ToMarkingM),
            ToMarkingR = NotAbove(values[3], 6.5, IndicatorRanges.ToMarkingR),
            DistL = NotAbove(values[4], 67.5, IndicatorRanges.Dist),
            DistR = NotAbove(values[5], 67.5, IndicatorRanges.Dist),
            ToMarkingLL = NotBelow(values[6], -8.5, IndicatorRanges.ToMarkingLL),
            ToMarkingML = NotBelow(values[7], -4.5, IndicatorRanges.ToMarkingML),
            ToMarkingMR = NotAbove(values[8], 4.5, IndicatorRanges.ToMarkingMR),
            ToMarkingRR = NotAbove(values[9], 8.5, IndicatorRanges.ToMarkingRR),
            DistLL = NotAbove(values[10], 67.5, IndicatorRanges.Dist),
            DistMM = NotAbove(values[11], 67.5, IndicatorRanges.Dist),
            DistRR = NotAbove(values[12], 67.5, IndicatorRanges.Dist),
        };
    }

    private static Indicator NotBelow(double value, double limit, IndicatorRange range) =>
        value >= limit ? Indicator.Of(value) : range.Inactive;

    private static Indicator NotAbove(double value, double limit, IndicatorRange range) =>
        value <= limit ? Indicator.Of(value) : range.Inactive;
}
