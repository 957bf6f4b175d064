using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Events;

namespace Harvester.Capture.Harvesting;

/// <summary>What is recorded when a session ends. All times are the game's, so that the same game gives the same end.</summary>
/// <param name="GameFrame">The game's frame count when it was last read.</param>
/// <param name="TimeSeconds">The game's time when it was last read, seconds.</param>
/// <param name="Captured">Frames handed to the sink, or left to other shards.</param>
/// <param name="Discards">Discarded frames by reason, in alphabetical order.</param>
/// <param name="SettleTicks">Number of frames by the ticks they needed until everything stood still, in ascending order; empty in live
/// mode.</param>
/// <param name="Lag">The measured picture lag; null if it was not measured.</param>
/// <param name="Fault">Why the harvest ended; null if it ended without a fault.</param>
public sealed record SessionEnd(
    long GameFrame,
    double TimeSeconds,
    int Captured,
    IReadOnlyList<KeyValuePair<string, int>> Discards,
    IReadOnlyList<KeyValuePair<int, int>> SettleTicks,
    PictureLag? Lag,
    string? Fault
)
{
    /// <summary>What could not be read of the game correctly; null for a game that is always read completely.</summary>
    public ReadingReport? Reading { get; init; }

    /// <summary>The events that have ended since the last frame; null if events are not recorded.</summary>
    public IReadOnlyList<DrivingEvent>? Events { get; init; }

    /// <summary>How well masks from rays agree with those from photographs; null if they are not compared.</summary>
    public MaskComparison? MaskComparison { get; init; }

    /// <summary>Why masks come from rays although others were asked for; null if they do not.</summary>
    public string? MaskWarning { get; init; }

    /// <summary>What spoils the pictures, one sentence; null if nothing was found.</summary>
    public string? PictureWarning { get; init; }
}
