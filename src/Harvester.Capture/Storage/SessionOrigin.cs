using System.Collections.Generic;

namespace Harvester.Capture.Storage;

/// <summary>
/// Where a session comes from, as its maker knows it. With the same origin and the same game, a session is the same to the byte.
/// </summary>
public sealed record SessionOrigin
{
    /// <summary>The game: "simulation", or "GTA V" with its version.</summary>
    public required string Game { get; init; }

    /// <summary>The program that ran the harvest and its version, such as "harvester 0.1.0".</summary>
    public required string Tool { get; init; }

    /// <summary>What everything random of the game was drawn from; null in a game without a seed.</summary>
    public long? Seed { get; init; }

    /// <summary>
    /// When the recording began, in the player's time, as the maker wants it written; null (as in the simulation) where the same seed must
    /// give the same bytes.
    /// </summary>
    public string? RecordedUtc { get; init; }

    /// <summary>Further settings of the game worth keeping, in the order in which they are to be written.</summary>
    public IReadOnlyList<KeyValuePair<string, string>> Settings { get; init; } = [];
}
