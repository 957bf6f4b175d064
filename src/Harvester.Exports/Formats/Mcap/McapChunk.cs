using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>Writes the chunk of a moment with the index records that follow it. Images are compressed already, so it is not.</summary>
internal static class McapChunk
{
    private const int IndexEntryBytes = 2 * sizeof(ulong);
    private const int MessageHeadBytes = McapRecord.HeadLength + sizeof(ushort) + sizeof(uint) + (2 * sizeof(ulong));
    private const int ChunkHeadBytes = McapRecord.HeadLength + (4 * sizeof(ulong)) + (2 * sizeof(uint));

    /// <summary>Writes the channels of messages, for a file whose channels are not known without them, before their chunk.</summary>
    public static void WriteChannels(Stream target, IReadOnlyList<McapMessage> messages)
    {
        foreach (McapChannel channel in messages.Select(message => message.Channel).Distinct().OrderBy(channel => channel.Id))
        {
            target.Write(McapDefinitions.ChannelRecord(channel));
        }
    }

    /// <summary>Writes the records of a moment, as they stand in the file.</summary>
    /// <param name="target">Where to.</param>
    /// <param name="nanoseconds">The moment, nanoseconds; it must not be negative.</param>
    /// <param name="sequence">Number of the moment, from 0.</param>
    /// <param name="messages">The messages, in order of their channels, and of their times.</param>
    public static void Write(Stream target, long nanoseconds, int sequence, IReadOnlyList<McapMessage> messages)
    {
        using var records = new MemoryStream(messages.Sum(message => message.Content.Length + MessageHeadBytes));
        var offsets = new List<(McapChannel Channel, long Time, long Offset)>();
        foreach (McapMessage message in messages)
        {
            long time = message.Nanoseconds ?? nanoseconds;
            offsets.Add((message.Channel, time, records.Length));
            using var record = new McapRecord(McapOpcode.Message, message.Content.Length + MessageHeadBytes);
            record.UInt16(message.Channel.Id).UInt32(sequence).UInt64(time).UInt64(time).Bytes(message.Content).WriteTo(records);
        }

        byte[] content = records.GetBuffer();
        int length = (int)records.Length;
        using var chunk = new McapRecord(McapOpcode.Chunk, length + ChunkHeadBytes);
        chunk
            .UInt64(nanoseconds)
            .UInt64(offsets.Max(entry => entry.Time))
            .UInt64(length)
            .UInt32(Crc32.Append(0, content, length))
            .Text("")
            .UInt64(length)
            .Bytes(content.AsSpan(0, length))
            .WriteTo(target);
        foreach (IGrouping<int, (McapChannel Channel, long Time, long Offset)> channel in offsets.GroupBy(entry => entry.Channel.Id))
        {
            using var index = new McapRecord(McapOpcode.MessageIndex);
            index
                .UInt16(channel.Key)
                .Entries([.. channel], IndexEntryBytes, entry => index.UInt64(entry.Time).UInt64(entry.Offset))
                .WriteTo(target);
        }
    }
}
