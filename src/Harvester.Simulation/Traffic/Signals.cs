using Harvester.Geometry.Roads;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>Traffic lights: at each signalled junction the crossing roads take turns.</summary>
internal sealed class Signals
{
    private const double GreenSeconds = 7;

    /// <summary>Long enough for a car at 20 m/s that can no longer stop at 4 m/s² to pass the line.</summary>
    private const double AmberSeconds = 3;

    /// <summary>Time in which all lights are red, so that the junction empties.</summary>
    private const double ClearanceSeconds = 1;
    private const double PhaseSeconds = GreenSeconds + AmberSeconds + ClearanceSeconds;
    private const double CycleSeconds = 2 * PhaseSeconds;

    /// <summary>Seconds by which the cycles of successive junctions differ, so that not all lights change at once.</summary>
    private const double OffsetSeconds = 7.3;

    private readonly Dictionary<Junction, double> _offsets = [];

    public Signals(RoadPlan plan, RoadNetwork network)
    {
        foreach (Junction junction in plan.Junctions.Where(junction => IsSignalled(junction, network)))
        {
            _offsets[junction] = junction.Node * OffsetSeconds % CycleSeconds;
        }
    }

    /// <summary>The junctions that have lights.</summary>
    public IEnumerable<Junction> Junctions => _offsets.Keys;

    public bool Has(Junction junction) => _offsets.ContainsKey(junction);

    /// <summary>The light for an arm's traffic; green if there are no lights.</summary>
    public SignalState ColourFor(Junction junction, RoadArm arm, double timeSeconds)
    {
        if (!_offsets.TryGetValue(junction, out double offset))
        {
            return SignalState.Green;
        }

        // Arms within 45° of the line of the first arm are the one road, the others the crossing one.
        double cosine = arm.Outward.Dot(junction.Arms[0].Outward);
        double phaseStart = Math.Abs(cosine) > Math.Sqrt(0.5) ? 0 : PhaseSeconds;
        double time = (timeSeconds + offset - phaseStart + CycleSeconds) % CycleSeconds;
        return time < GreenSeconds ? SignalState.Green
            : time < GreenSeconds + AmberSeconds ? SignalState.Amber
            : SignalState.Red;
    }

    private static bool IsSignalled(Junction junction, RoadNetwork network)
    {
        const int minArms = 3;
        const double stopLineRange = 45;
        return junction.Arms.Count >= minArms && junction.Arms.Count(HasStopLine) >= 2;

        bool HasStopLine(RoadArm arm) =>
            !arm.Road.IsInner
            && arm.Road.Nodes.Any(node =>
                network.Nodes[node].Flags.HasFlag(RoadNodeFlags.TrafficLight)
                && (network.Nodes[node].Position - junction.Position).Length < stopLineRange
            );
    }
}
