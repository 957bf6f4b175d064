using Harvester.Capture.Ports;

namespace Harvester.Tapes;

/// <summary>The clock of a tape.</summary>
/// <param name="tape">The tape.</param>
internal sealed class PlayedClock(TapeCursor tape) : IClock
{
    /// <inheritdoc/>
    public double Milliseconds => tape.TakeClock();
}
