namespace Harvester.Datasets.Statistics;

/// <summary>The range of an indicator over the frames in which it is valid.</summary>
/// <param name="Count">Number of these frames.</param>
/// <param name="Min">Smallest value, metres or radians.</param>
/// <param name="Max">Largest value.</param>
public readonly record struct IndicatorSpan(int Count, double Min, double Max)
{
    /// <summary>The range extended by a value.</summary>
    public IndicatorSpan With(double value) =>
        Count == 0 ? new IndicatorSpan(1, value, value) : new IndicatorSpan(Count + 1, Math.Min(Min, value), Math.Max(Max, value));
}
