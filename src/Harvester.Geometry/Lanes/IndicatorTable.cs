using static Harvester.Geometry.Lanes.IndicatorQuantity;

namespace Harvester.Geometry.Lanes;

/// <summary>
/// The thirteen indicators in the order of DeepDriving's training data, which is also their order in labels and on the live bridge. Ranges
/// are those of Figure 15 of the thesis, inactive values those of DeepDriving's driver for TORCS, for lanes 4 metres wide. All code that
/// lists the indicators uses this table.
/// </summary>
public static class IndicatorTable
{
    private const double VehicleLimit = 67.5;

    /// <summary>
    /// In sharp bends the road ahead turns by more than the half radian of Figure 15; only <see cref="DeepDrivingNormalisation"/> clips it.
    /// </summary>
    private static readonly IndicatorRange AngleRange = new(-Math.PI, Math.PI, 0);

    /// <summary>A free lane has the maximum value; a lane that does not exist has the inactive value.</summary>
    private static readonly IndicatorRange DistRange = new(0, IndicatorCalculator.VehicleRange, 75);

    /// <summary>The indicators, in order.</summary>
    public static IReadOnlyList<IndicatorDefinition> All { get; } =
    [
        new(Angle, "", AngleRange, null, at => at.Angle, (at, value) => at with { Angle = value }, DeepDrivingNormalisation.Angle),
        Marking(
            "L",
            new(-7, -2.5, -7),
            -6.5,
            at => at.ToMarkingL,
            (at, value) => at with { ToMarkingL = value },
            DeepDrivingNormalisation.ToMarkingL
        ),
        Marking(
            "M",
            new(-2, 3.5, 3.5),
            2.75,
            at => at.ToMarkingM,
            (at, value) => at with { ToMarkingM = value },
            DeepDrivingNormalisation.ToMarkingM
        ),
        Marking(
            "R",
            new(2.5, 7, 7),
            6.5,
            at => at.ToMarkingR,
            (at, value) => at with { ToMarkingR = value },
            DeepDrivingNormalisation.ToMarkingR
        ),
        Vehicle("L", at => at.DistL, (at, value) => at with { DistL = value }),
        Vehicle("R", at => at.DistR, (at, value) => at with { DistR = value }),
        Marking(
            "LL",
            new(-9.5, -4, -9.5),
            -8.5,
            at => at.ToMarkingLL,
            (at, value) => at with { ToMarkingLL = value },
            DeepDrivingNormalisation.ToMarkingLL
        ),
        Marking(
            "ML",
            new(-5.5, -0.5, -5.5),
            -4.5,
            at => at.ToMarkingML,
            (at, value) => at with { ToMarkingML = value },
            DeepDrivingNormalisation.ToMarkingML
        ),
        Marking(
            "MR",
            new(0.5, 5.5, 5.5),
            4.5,
            at => at.ToMarkingMR,
            (at, value) => at with { ToMarkingMR = value },
            DeepDrivingNormalisation.ToMarkingMR
        ),
        Marking(
            "RR",
            new(4, 9.5, 9.5),
            8.5,
            at => at.ToMarkingRR,
            (at, value) => at with { ToMarkingRR = value },
            DeepDrivingNormalisation.ToMarkingRR
        ),
        Vehicle("LL", at => at.DistLL, (at, value) => at with { DistLL = value }),
        Vehicle("MM", at => at.DistMM, (at, value) => at with { DistMM = value }),
        Vehicle("RR", at => at.DistRR, (at, value) => at with { DistRR = value }),
    ];

    /// <summary>Number of indicators: thirteen.</summary>
    public static int Count => All.Count;

    /// <summary>The position of an indicator in the order, from 0.</summary>
    /// <exception cref="ArgumentException">No indicator has this name.</exception>
    public static int IndexOf(string name)
    {
        int index = All.TakeWhile(indicator => indicator.Name != name).Count();
        return index < Count ? index : throw new ArgumentException($"'{name}' is not the name of an indicator.", nameof(name));
    }

    private static IndicatorDefinition Marking(
        string place,
        IndicatorRange range,
        double activeLimit,
        Func<LaneIndicators, Indicator> read,
        Func<LaneIndicators, Indicator, LaneIndicators> replace,
        Func<double, double> normalise
    ) => new(ToMarking, place, range, activeLimit, read, replace, normalise);

    private static IndicatorDefinition Vehicle(
        string place,
        Func<LaneIndicators, Indicator> read,
        Func<LaneIndicators, Indicator, LaneIndicators> replace
    ) => new(Dist, place, DistRange, VehicleLimit, read, replace, DeepDrivingNormalisation.Dist);
}
