namespace Harvester.Exports.Tests.Mcap;

/// <summary>Splits the bytes of an MCAP file into records, without the program's own reader.</summary>
internal static class McapRecords
{
    private const int MagicLength = 8;

    /// <summary>The records between the magic bytes: where each starts, its kind and its content.</summary>
    public static IEnumerable<(int Start, byte Kind, byte[] Content)> Of(byte[] file) => Of(file, MagicLength, file.Length - MagicLength);

    /// <summary>The messages of all chunks, in the order of the file: channel, sequence, time and content.</summary>
    public static IEnumerable<(int Channel, uint Sequence, ulong Time, byte[] Content)> Messages(byte[] file)
    {
        foreach ((_, byte kind, byte[] chunk) in Of(file).Where(record => record.Kind == 6))
        {
            // Two times, a length, a checksum, an empty name of the compression, and the length of the content.
            const int contentAt = 8 + 8 + 8 + 4 + 4 + 8;
            foreach ((_, byte inner, byte[] message) in Of(chunk, contentAt, chunk.Length))
            {
                Assert.Equal((6, 5), (kind, inner));
                yield return (
                    BitConverter.ToUInt16(message),
                    BitConverter.ToUInt32(message, 2),
                    BitConverter.ToUInt64(message, 6),
                    message[22..]
                );
            }
        }
    }

    private static IEnumerable<(int Start, byte Kind, byte[] Content)> Of(byte[] bytes, int from, int to)
    {
        for (int at = from; at < to; )
        {
            int length = checked((int)BitConverter.ToUInt64(bytes, at + 1));
            yield return (at, bytes[at], bytes[(at + 9)..(at + 9 + length)]);
            at += 9 + length;
        }
    }
}
