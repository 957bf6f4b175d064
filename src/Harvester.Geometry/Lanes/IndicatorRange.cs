namespace Harvester.Geometry.Lanes;

/// <summary>The values that an indicator takes with lanes 4 metres wide.</summary>
/// <param name="Min">Minimum value while active.</param>
/// <param name="Max">Maximum value while active.</param>
/// <param name="InactiveValue">The value while inactive.</param>
public readonly record struct IndicatorRange(double Min, double Max, double InactiveValue)
{
    /// <summary>The indicator that stands for no value.</summary>
    public Indicator Inactive => Indicator.Inactive(InactiveValue);
}
