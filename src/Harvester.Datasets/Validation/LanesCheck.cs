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

        if (lanes.LaneWidthsMetres is { } laneWidths && !laneWidths.All(static width => width > 0))
        {
            yield return "lanes.laneWidthsMetres must be greater than 0.";
        }

        foreach (LaneLineView marking in (lanes.Markings ?? []).Where(static line => line.SigmaMetres < 0))
        {
            yield return FormattableString.Invariant($"lanes.markings: sigmaMetres is {marking.SigmaMetres}; it must be 0 or more.");
        }

        // The lane widths are known at the look-ahead point only; at the car they may differ.
        IReadOnlyList<double> widths = lanes.LaneWidthsMetres is { Count: > 0 } each
            ? each
            : [lanes.LaneWidthMetres ?? LaneSection.TorcsLaneWidth];
        (double Least, double Most) atLookAhead = (widths.Min() / LaneSection.TorcsLaneWidth, widths.Max() / LaneSection.TorcsLaneWidth);
        foreach (
            (string name, LaneIndicators indicators, (double, double)? scaleOfMarkings) in new (
                string Name,
                LaneIndicators Indicators,
                (double Least, double Most)? Scale
            )[]
            {
                ("indicators", lanes.Indicators, atLookAhead),
                ("torcsEquivalent", lanes.TorcsEquivalent, (1, 1)),
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

    private static string? Problem(IndicatorDefinition definition, Indicator indicator, (double Least, double Most)? scale)
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

        (double least, double most) = isToMarking ? scale!.Value : (1, 1);
        double from = Math.Min(range.Min * least, range.Min * most);
        double to = Math.Max(range.Max * least, range.Max * most);
        return indicator.Value < from - Rounding || indicator.Value > to + Rounding
            ? FormattableString.Invariant($"{indicator.Value}; it must be {from:0.##} to {to:0.##}.")
            : null;
    }
}
