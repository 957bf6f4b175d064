using Harvester.Capture.Ports;

namespace Harvester.Capture.Tests.Playing;

/// <summary>The player's time, as the test sets it.</summary>
internal sealed class TestClock : IClock
{
    public double Milliseconds { get; set; }
}
