using Harvester.Geometry.Lanes;

namespace Harvester.Runs.Driving;

/// <summary>
/// Decides who drives: the controller where the indicators show the lanes in which the car is and what it has to do, otherwise the built-in
/// driver. That hands back once the car is near the centre of its lane and nearly parallel to it, and no sharp bend is ahead, of which a
/// controller that begins there would not know where it begins. At first, the controller drives.
/// </summary>
public sealed class Handover
{
    /// <summary>Radians between car and lane up to which the built-in driver hands back.</summary>
    private const double MaxAngle = 0.15;

    /// <summary>
    /// Distance from the centre of the lane, in lane widths, up to which the built-in driver hands back: 0.8 m in an ordinary lane. With
    /// the angle, a car 2 m wide is then still within a lane of 4 m.
    /// </summary>
    private const double MaxOffset = 0.15;

    /// <summary>Radians that the road may turn up to the look-ahead point where the built-in driver hands back.</summary>
    private const double MaxBend = 0.3;

    /// <summary>
    /// Metres by which the lanes at the look-ahead point may lie beside those at the car. Farther to the side are the lanes behind a
    /// junction, towards which the car must not steer before it.
    /// </summary>
    private const double MaxShift = 0.5;

    /// <summary>Whether the controller drives.</summary>
    public bool IsToController { get; private set; } = true;

    /// <summary>Decides for the current moment.</summary>
    /// <param name="seen">The lanes now; null if there is no road.</param>
    /// <param name="needsOwnDriver">Whether no indicator shows what the car has to do, as in junctions.</param>
    public bool Decide(LaneObservation? seen, bool needsOwnDriver)
    {
        IsToController =
            seen is { Status: LaneStatus.Known }
            && !needsOwnDriver
            && !AreLanesShifted(seen)
            && (IsToController || (IsInLane(seen.IndicatorsAtCar) && !IsBendAhead(seen)));
        return IsToController;
    }

    private static bool AreLanesShifted(LaneObservation seen) =>
        IsShifted(seen.IndicatorsAtCar.ToMarkingML, seen.Indicators.ToMarkingML)
        || IsShifted(seen.IndicatorsAtCar.ToMarkingMR, seen.Indicators.ToMarkingMR)
        || IsShifted(seen.IndicatorsAtCar.ToMarkingM, seen.Indicators.ToMarkingM);

    private static bool IsShifted(Indicator here, Indicator there) =>
        here.IsValid != there.IsValid || (here.IsValid && Math.Abs(here.Value - there.Value) > MaxShift);

    private static bool IsBendAhead(LaneObservation seen) =>
        Math.Abs(seen.Indicators.Angle.Value - seen.IndicatorsAtCar.Angle.Value) > MaxBend;

    private static bool IsInLane(LaneIndicators at) =>
        Math.Abs(at.Angle.Value) < MaxAngle
        && at.ToMarkingML.IsValid
        && Math.Abs(at.ToMarkingML.Value + at.ToMarkingMR.Value) / 2 < MaxOffset * (at.ToMarkingMR.Value - at.ToMarkingML.Value);
}
