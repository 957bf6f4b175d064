using Harvester.Geometry.Lanes;

namespace Harvester.Sessions.Labels;

/// <summary>
/// The thirteen indicators as a row of numbers, in the order of <see cref="IndicatorTable"/>: radians for the angle, metres for the others.
/// </summary>
public static class IndicatorOrder
{
    /// <summary>Maximum absolute value, metres or radians; larger values cannot come from a road and are rejected.</summary>
    public const double MaxValue = 1000;

    /// <summary>The values in order; an inactive indicator has its inactive value.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="indicators"/> is null.</exception>
    public static double[] Values(LaneIndicators indicators) => [.. IndicatorTable.All.Select(indicator => indicator.Of(indicators).Value)];

    /// <summary>
    /// Creates indicators from values as a network estimates them, scaled to a road of TORCS. A network gives no flags and does not output
    /// an inactive value exactly, so each indicator is active up to its <see cref="IndicatorDefinition.ActiveLimit"/>.
    /// </summary>
    /// <exception cref="ArgumentException">There are not thirteen values, or one is not within -1000 to 1000.</exception>
    public static LaneIndicators FromValues(IReadOnlyList<double> values)
    {
        if (values is null || values.Count != IndicatorTable.Count)
        {
            throw new ArgumentException("There are thirteen indicators.", nameof(values));
        }

        if (!values.All(static value => Math.Abs(value) <= MaxValue))
        {
            throw new ArgumentException(
                FormattableString.Invariant($"An indicator is not in the range -{MaxValue} to {MaxValue}."),
                nameof(values)
            );
        }

        int next = 0;
        return LaneIndicators.From(indicator => indicator.Estimate(values[next++]));
    }
}
