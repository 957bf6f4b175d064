using Harvester.Capture.Ports;

namespace Harvester.TestSupport;

/// <summary>Counts of calls to the game, set by the test.</summary>
internal sealed class TestCalls : ICallCounter
{
    public long Natives { get; set; }

    public long Rays { get; set; }
}
