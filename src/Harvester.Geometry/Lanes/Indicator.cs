namespace Harvester.Geometry.Lanes;

/// <summary>The value of an indicator, and whether it says anything.</summary>
/// <param name="Value">Metres or radians; the indicator's inactive value when it is not valid.</param>
/// <param name="IsValid">Whether the system that the indicator belongs to is active here and what it measures is there.</param>
public readonly record struct Indicator(double Value, bool IsValid)
{
    /// <summary>A value that says something.</summary>
    public static Indicator Of(double value) => new(value, true);

    /// <summary>The value that stands for nothing.</summary>
    public static Indicator Inactive(double value) => new(value, false);
}
