using System.Collections.Generic;
using System.IO;
using System.Linq;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Datasets.Exports.Formats.Mcap;

/// <summary>Builds the chunk of a moment with the index records that follow it. Images are compressed already, so it is not.</summary>
internal static class McapChunk
{
    private const int IndexEntryBytes = 2 * sizeof(ulong);

    /// <summary>The records of a moment, as they stand in the file.</summary>
    /// <param name="nanoseconds">The moment, nanoseconds; it must not be negative.</param>
    /// <param name="sequence">Number of the moment, from 0.</param>
    /// <param name="messages">The messages, in order of their channels.</param>
    public static byte[] Of(long nanoseconds, int sequence, IReadOnlyList<McapMessage> messages)
    {
        using var records = new MemoryStream();
        var offsets = new List<(McapChannel Channel, long Offset)>();
        foreach (McapMessage message in messages)
        {
            offsets.Add((message.Channel, records.Length));
            using var record = new McapRecord(McapOpcode.Message);
            records.Write(record.UInt16(message.Channel.Id).UInt32(sequence).UInt64(nanoseconds).UInt64(nanoseconds)
                .Bytes(message.Content).ToArray());
        }

        byte[] content = records.ToArray();
        using var chunk = new McapRecord(McapOpcode.Chunk);
        chunk.UInt64(nanoseconds).UInt64(nanoseconds).UInt64(content.Length).UInt32(Crc32.Append(0, content, content.Length))
            .Text("").UInt64(content.Length).Bytes(content);
        return [.. chunk.ToArray(), .. offsets.GroupBy(entry => entry.Channel.Id).SelectMany(Index)];

        byte[] Index(IGrouping<int, (McapChannel Channel, long Offset)> channel)
        {
            using var index = new McapRecord(McapOpcode.MessageIndex);
            return index.UInt16(channel.Key)
                .Entries([.. channel], IndexEntryBytes, entry => index.UInt64(nanoseconds).UInt64(entry.Offset)).ToArray();
        }
    }
}
