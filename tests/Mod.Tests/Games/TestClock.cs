using Harvester.Capture.Ports;

namespace Harvester.Mod.Tests.Games;

/// <summary>The player's time, as a test lets it pass.</summary>
internal sealed class TestClock : IClock
{
    public double Milliseconds { get; set; }
}
