namespace Harvester.Geometry.Lanes;

/// <summary>What values an indicator takes with lanes 4 metres wide.</summary>
/// <param name="Min">Least value while active.</param>
/// <param name="Max">Greatest value while active.</param>
/// <param name="InactiveValue">The value that stands for nothing.</param>
public readonly record struct IndicatorRange(double Min, double Max, double InactiveValue)
{
    /// <summary>The indicator that says nothing.</summary>
    public Indicator Inactive => Indicator.Inactive(InactiveValue);
}
