namespace Harvester.Geometry.Lanes;

/// <summary>The value of an indicator, and whether it is active.</summary>
/// <param name="Value">Metres or radians; the indicator's inactive value if it is not valid.</param>
/// <param name="IsValid">Whether the indicator's system (in lane or on marking) is active here and what it measures exists.</param>
public readonly record struct Indicator(double Value, bool IsValid)
{
    /// <summary>An active indicator with a value.</summary>
    public static Indicator Of(double value) => new(value, true);

    /// <summary>The value of an inactive indicator.</summary>
    public static Indicator Inactive(double value) => new(value, false);
}
