using Harvester.Capture.Ports;

namespace Harvester.Capture.Harvesting;

/// <summary>How much of a tick may be used.</summary>
internal sealed class TickBudget(IClock clock, double milliseconds)
{
    private double _tickStart;

    public bool IsSpent => clock.Milliseconds - _tickStart >= milliseconds;

    public void BeginTick() => _tickStart = clock.Milliseconds;
}
