using Harvester.Capture.Ports;

namespace Harvester.TestSupport;

/// <summary>The player's time, as the test sets it; other threads may read it.</summary>
internal sealed class TestClock : IClock
{
    private double _milliseconds;

    public double Milliseconds
    {
        get => Volatile.Read(ref _milliseconds);
        set => Volatile.Write(ref _milliseconds, value);
    }
}
