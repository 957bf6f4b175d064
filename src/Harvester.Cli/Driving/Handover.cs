using System;
using Harvester.Geometry.Lanes;

namespace Harvester.Cli.Driving;

/// <summary>
/// Who has the wheel: the controller where the lanes are known and nobody comes first, else the car's own driver. He gives it back when
/// the car is in its lane and along it, as one would to anybody. In the beginning it is the controller's.
/// </summary>
internal sealed class Handover
{
    private const double MaxAngle = 0.15;
    private const double MaxOffset = 0.8;

    /// <summary>Whether the controller drives.</summary>
    public bool IsToController { get; private set; } = true;

    /// <summary>Decides anew.</summary>
    /// <param name="seen">The lanes now; null when no road is known.</param>
    /// <param name="mustGiveWay">Whether the car has to stop at a line ahead, which no indicator shows.</param>
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
