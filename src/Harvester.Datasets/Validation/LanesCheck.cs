using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>
/// Checks the lanes of a frame against the ranges of docs/lanes.md, scaled with the lane width, and the values of invalid indicators.
/// </summary>
internal static class LanesCheck
{
    /// <summary>Tolerance: numbers are rounded to at least three decimals, and scaled with the lane width.</summary>
    private const double Rounding = 0.01;

    public static IEnumerable<string> Problems(LanesLabel lanes)
    {
        if (lanes.Confidence is < 0 or > 1)
        {
            yield return FormattableString.Invariant($"lanes.confidence is {lanes.Confidence}; it must be 0 to 1.");
        }

        if (lanes.Lane is { } lane && lanes.LaneCount is { } count && (lane < 0 || lane >= count))
        {
            yield return $"lanes.lane is {lane}, but lanes.laneCount is {count}.";
        }

        // The lane width is known at the look-ahead point only; at the car it may differ.
        double atLookAhead = (lanes.LaneWidthMetres ?? LaneSection.TorcsLaneWidth) / LaneSection.TorcsLaneWidth;
        foreach (
            (string name, LaneIndicators indicators, double? scaleOfMarkings) in new (
                string Name,
                LaneIndicators Indicators,
                double? Scale
            )[]
            {
                ("indicators", lanes.Indicators, atLookAhead),
                ("torcsEquivalent", lanes.TorcsEquivalent, 1),
                ("atCar.indicators", lanes.IndicatorsAtCar, null),
            }
        )
        {
            foreach (IndicatorDefinition indicator in IndicatorTable.All)
            {
                if (Problem(indicator, indicator.Of(indicators), scaleOfMarkings) is { } problem)
                {
                    yield return $"lanes.{name}.{indicator.Name} is {problem}";
                }
            }
        }
    }

    private static string? Problem(IndicatorDefinition definition, Indicator indicator, double? scale)
    {
        bool isToMarking = definition.Quantity == IndicatorQuantity.ToMarking;
        IndicatorRange range = definition.Range;
        if (!indicator.IsValid)
        {
            return Math.Abs(indicator.Value - range.InactiveValue) > Rounding
                ? FormattableString.Invariant($"{indicator.Value}, but an invalid indicator must have {range.InactiveValue}.")
                : null;
        }

        if (isToMarking && scale is null)
        {
            return null;
        }

        double by = isToMarking ? scale!.Value : 1;
        return indicator.Value < (range.Min * by) - Rounding || indicator.Value > (range.Max * by) + Rounding
            ? FormattableString.Invariant($"{indicator.Value}; it must be {range.Min * by:0.##} to {range.Max * by:0.##}.")
            : null;
    }
}
