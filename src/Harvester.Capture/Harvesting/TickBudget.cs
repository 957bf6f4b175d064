using Harvester.Capture.Ports;

namespace Harvester.Capture.Harvesting;

/// <summary>The time that may be used in one tick.</summary>
internal sealed class TickBudget(IClock clock, double milliseconds)
{
    private double _tickStart;

    public bool IsSpent => clock.Milliseconds - _tickStart >= milliseconds;

    public void BeginTick() => _tickStart = clock.Milliseconds;
}
