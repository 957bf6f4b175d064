using Harvester.Capture.Ports;

namespace Harvester.TestSupport;

/// <summary>What was asked of the game, as the test says.</summary>
internal sealed class TestCalls : ICallCounter
{
    public long Natives { get; set; }

    public long Rays { get; set; }
}
