using Harvester.Capture.Ports;

namespace Harvester.Play.Tapes;

/// <summary>A clock whose readings are recorded.</summary>
/// <param name="clock">The clock.</param>
/// <param name="tape">The recording.</param>
public sealed class TapedClock(IClock clock, TapeRecorder tape) : IClock
{
    /// <inheritdoc/>
    public double Milliseconds => tape.Clock(clock.Milliseconds);
}
