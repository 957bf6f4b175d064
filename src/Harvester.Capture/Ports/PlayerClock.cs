using System.Diagnostics;

namespace Harvester.Capture.Ports;

/// <summary>Real time, from the computer's clock.</summary>
public sealed class PlayerClock : IClock
{
    private readonly Stopwatch _watch = Stopwatch.StartNew();

    /// <inheritdoc/>
    public double Milliseconds => _watch.Elapsed.TotalMilliseconds;
}
