using System;
using Harvester.Geometry.Lanes;

namespace Harvester.Cli.Driving;

/// <summary>
/// Decides who drives: the controller where the lanes are known and the car need not give way, otherwise the built-in driver. The built-in
/// driver hands back once the car is near the centre of its lane and nearly parallel to it. At first, the controller drives.
/// </summary>
internal sealed class Handover
{
    // Radians between car and lane, and metres from the centre of the lane, up to which the built-in driver hands back.
    private const double MaxAngle = 0.15;
    private const double MaxOffset = 0.8;

    /// <summary>Whether the controller drives.</summary>
    public bool IsToController { get; private set; } = true;

    /// <summary>Decides for the current moment.</summary>
    /// <param name="seen">The lanes now; null if there is no road.</param>
    /// <param name="mustGiveWay">Whether the car must stop at a line ahead, which no indicator shows.</param>
    public bool Decide(LaneObservation? seen, bool mustGiveWay)
    {
        IsToController = seen is { Status: LaneStatus.Known } && !mustGiveWay && (IsToController || IsInLane(seen.IndicatorsAtCar));
        return IsToController;
    }

    private static bool IsInLane(LaneIndicators at) =>
        Math.Abs(at.Angle.Value) < MaxAngle
        && at.ToMarkingML.IsValid
        && Math.Abs(at.ToMarkingML.Value + at.ToMarkingMR.Value) / 2 < MaxOffset;
}
