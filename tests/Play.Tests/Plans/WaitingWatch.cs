using Harvester.Capture.Ports;

namespace Harvester.Play.Tests.Plans;

/// <summary>Waits for work on other threads, so that the ticks of a test are not faster than it.</summary>
internal sealed class WaitingWatch : IBackgroundWatch
{
    private static readonly TimeSpan Longest = TimeSpan.FromSeconds(30);

    public bool IsDone(string what, Func<bool> isDone) => SpinWait.SpinUntil(isDone, Longest);
}
