namespace Harvester.Exports.Formats.Mcap;

/// <summary>A message of a channel.</summary>
/// <param name="Channel">The channel.</param>
/// <param name="Content">The protobuf message.</param>
internal sealed record McapMessage(McapChannel Channel, byte[] Content)
{
    /// <summary>Its time, nanoseconds, not before that of its chunk; null if it is that of the chunk.</summary>
    public long? Nanoseconds { get; init; }
}
