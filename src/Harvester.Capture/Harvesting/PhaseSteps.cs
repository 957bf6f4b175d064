using Harvester.Geometry.Work;

namespace Harvester.Capture.Harvesting;

/// <summary>Steps of works that name the phase of the harvest.</summary>
internal static class PhaseSteps
{
    /// <summary>The work goes on in the next tick.</summary>
    public static WorkStep Tick(this HarvestPhase phase) => WorkStep.TickIn((int)phase);

    /// <summary>Another work is done before the next step; wherever it stands still, it is in this phase unless it names another.</summary>
    public static WorkStep Do(this HarvestPhase phase, IEnumerable<WorkStep> work) => WorkStep.Do(work, (int)phase);
}
