using Google.Protobuf.WellKnownTypes;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>Times of messages.</summary>
internal static class MessageTime
{
    private const long NanosecondsPerSecond = 1_000_000_000;

    /// <summary>A time as protobuf has it: seconds, and the nanoseconds after them.</summary>
    public static Timestamp Of(long nanoseconds) =>
        new() { Seconds = nanoseconds / NanosecondsPerSecond, Nanos = (int)(nanoseconds % NanosecondsPerSecond) };
}
