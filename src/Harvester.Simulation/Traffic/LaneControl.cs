using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>What tells traffic to wait at the end of a lane: the light or the stop sign there.</summary>
/// <param name="signals">The traffic lights.</param>
/// <param name="stopArms">The arms of junctions that have a stop sign.</param>
internal sealed class LaneControl(Signals signals, IReadOnlySet<(Junction Junction, RoadArm Arm)> stopArms)
{
    /// <summary>The light for the traffic of a lane at its end; null if none stands there.</summary>
    public SignalState? LightFor(LanePath lane, Junction junction, double timeSeconds) =>
        signals.Has(junction) && !lane.Road!.IsTooShortToWait && ArmOf(lane, junction) is { } arm
            ? signals.ColourFor(junction, arm, timeSeconds)
            : null;

    /// <summary>Whether a stop sign stands at the end of a lane.</summary>
    public bool HasStopSign(LanePath lane, Junction junction) => ArmOf(lane, junction) is { } arm && stopArms.Contains((junction, arm));

    private static RoadArm? ArmOf(LanePath lane, Junction junction)
    {
        RoadArm arm = new(lane.Road!, AtStart: !lane.IsForward);
        return junction.Arms.Contains(arm) ? arm : null;
    }
}
