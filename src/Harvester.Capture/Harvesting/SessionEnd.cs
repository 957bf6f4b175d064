using System.Collections.Generic;
using Harvester.Capture.Ports;

namespace Harvester.Capture.Harvesting;

/// <summary>What is known when a session ends. All times are the game's, so that the same game gives the same end.</summary>
/// <param name="GameFrame">The game's count of frames when it was last read.</param>
/// <param name="TimeSeconds">The game's time when it was last read, seconds.</param>
/// <param name="Captured">Frames handed to the sink, or left to other shards.</param>
/// <param name="Discards">Frames thrown away, by reason, in the order of the reasons' letters.</param>
/// <param name="SettleTicks">How many frames needed how many ticks until everything stood still, by rising ticks; empty in live
/// mode.</param>
/// <param name="Lag">The lag of the picture as it was measured; null when it was not.</param>
/// <param name="Fault">Why the harvest ended; null for a good end.</param>
public sealed record SessionEnd(
    long GameFrame,
    double TimeSeconds,
    int Captured,
    IReadOnlyList<KeyValuePair<string, int>> Discards,
    IReadOnlyList<KeyValuePair<int, int>> SettleTicks,
    PictureLag? Lag,
    string? Fault)
{
    /// <summary>What could not be read of the game as it should be; null for a game that is always read in full.</summary>
    public ReadingReport? Reading { get; init; }
}
