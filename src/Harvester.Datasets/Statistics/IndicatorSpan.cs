using System;

namespace Harvester.Datasets.Statistics;

/// <summary>Between what values an indicator was, where it was valid.</summary>
/// <param name="Count">In how many frames it was.</param>
/// <param name="Least">Its least value, metres or radians.</param>
/// <param name="Greatest">Its greatest value.</param>
public readonly record struct IndicatorSpan(int Count, double Least, double Greatest)
{
    /// <summary>The span with one value more.</summary>
    public IndicatorSpan With(double value) =>
        Count == 0 ? new IndicatorSpan(1, value, value) : new IndicatorSpan(Count + 1, Math.Min(Least, value), Math.Max(Greatest, value));
}
