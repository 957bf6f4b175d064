namespace Harvester.Capture.Storage;

/// <summary>Where a session comes from. The same origin and the same game give the same session, byte for byte.</summary>
public sealed record SessionOrigin
{
    /// <summary>The game: "simulation", or "GTA V" with its version.</summary>
    public required string Game { get; init; }

    /// <summary>The program that ran the harvest and its version, such as "harvester 0.1.0".</summary>
    public required string Tool { get; init; }

    /// <summary>The seed of everything random in the game; null for a game without a seed.</summary>
    public long? Seed { get; init; }

    /// <summary>
    /// The start of the recording in the player's time, as text; null where the same seed must give the same bytes, as in the simulation.
    /// </summary>
    public string? RecordedUtc { get; init; }

    /// <summary>Which labels are exact and which are estimated, in the order in which they are written; empty if unknown.</summary>
    public IReadOnlyList<KeyValuePair<string, LabelTruth>> Truth { get; init; } = [];

    /// <summary>Further settings of the game worth keeping, in the order in which they are written.</summary>
    public IReadOnlyList<KeyValuePair<string, string>> Settings { get; init; } = [];
}
