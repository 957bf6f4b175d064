namespace Harvester.Runs.Supervising;

/// <summary>What reading the heartbeat gave.</summary>
/// <param name="Bytes">The content of the file; empty without one.</param>
/// <param name="Heartbeat">The heartbeat; null if there is none that can be read.</param>
/// <param name="Problem">Why the file cannot be read, a sentence; null if it can, or is missing.</param>
public sealed record HeartbeatReading(ReadOnlyMemory<byte> Bytes, SeenHeartbeat? Heartbeat, string? Problem)
{
    /// <summary>There is no file.</summary>
    public static HeartbeatReading Missing { get; } = new(default, null, null);

    /// <summary>Whether the file still has the content of another reading, such as one before the program was started.</summary>
    public bool IsSameAs(HeartbeatReading other) => Bytes.Span.SequenceEqual(other.Bytes.Span);
}
