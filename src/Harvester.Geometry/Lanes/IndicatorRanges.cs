using System;

namespace Harvester.Geometry.Lanes;

/// <summary>
/// The ranges of Figure 15 of the thesis and the inactive values of DeepDriving's driver for TORCS, for lanes 4 metres wide.
/// </summary>
public static class IndicatorRanges
{
    /// <summary>
    /// Radians. In sharp bends the road ahead turns by more than the half radian of Figure 15, which is what DeepDriving's normalisation
    /// spans; nothing but <see cref="DeepDrivingNormalisation"/> cuts it.
    /// </summary>
    public static IndicatorRange Angle { get; } = new(-Math.PI, Math.PI, 0);

    /// <summary>Metres.</summary>
    public static IndicatorRange ToMarkingL { get; } = new(-7, -2.5, -7);

    /// <summary>Metres.</summary>
    public static IndicatorRange ToMarkingM { get; } = new(-2, 3.5, 3.5);

    /// <summary>Metres.</summary>
    public static IndicatorRange ToMarkingR { get; } = new(2.5, 7, 7);

    /// <summary>Metres.</summary>
    public static IndicatorRange ToMarkingLL { get; } = new(-9.5, -4, -9.5);

    /// <summary>Metres.</summary>
    public static IndicatorRange ToMarkingML { get; } = new(-5.5, -0.5, -5.5);

    /// <summary>Metres.</summary>
    public static IndicatorRange ToMarkingMR { get; } = new(0.5, 5.5, 5.5);

    /// <summary>Metres.</summary>
    public static IndicatorRange ToMarkingRR { get; } = new(4, 9.5, 9.5);

    /// <summary>All distances to vehicles, metres.</summary>
    public static IndicatorRange Dist { get; } = new(0, 75, 75);
}
