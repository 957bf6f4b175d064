using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>
/// Writes an MCAP file around the chunks of its moments: header, schemas and channels before them, and the summary with its indexes after
/// them (mcap.dev/spec, "File Structure").
/// </summary>
internal sealed class McapFile
{
    private const string Library = "GtaDataHarvester";
    private const int OffsetBytes = sizeof(ushort) + sizeof(ulong);

    private readonly Stream _stream;
    private readonly List<ChunkEntry> _chunks = [];
    private long _position;
    private uint _crc;
    private readonly SortedSet<int> _schemas = [];
    private readonly SortedDictionary<int, McapChannel> _channels = [];

    private McapFile(Stream stream) => _stream = stream;

    /// <summary>The bytes at both ends of a file.</summary>
    public static ReadOnlySpan<byte> Magic => [0x89, (byte)'M', (byte)'C', (byte)'A', (byte)'P', (byte)'0', (byte)'\r', (byte)'\n'];

    /// <summary>Writes a file.</summary>
    /// <param name="stream">Where to.</param>
    /// <param name="chunks">
    /// The chunks with their indexes, from <see cref="McapChunk"/>, by rising time; of a rig, after the channels of their messages.
    /// </param>
    /// <exception cref="DatasetFormatException">A chunk is damaged.</exception>
    public static void Write(Stream stream, IEnumerable<byte[]> chunks)
    {
        var file = new McapFile(stream);
        file.Append(Magic.ToArray());
        file.Append(Header());
        foreach (byte[] staged in chunks)
        {
            McapChannel[] listed = [.. ChannelsBefore(staged)];
            byte[] chunk = staged[listed.Sum(channel => McapDefinitions.ChannelRecord(channel).Length)..];
            file.Define(listed.Length > 0 ? listed : McapChannel.OfSessions);
            IReadOnlyList<int> used = ChunkEntry.Of(chunk, file._position).Messages;

            // The channels that only some files have are defined where they are first used, because only the chunks tell of them.
            foreach (McapChannel[] some in McapChannel.OfSome.Where(some => some.Any(channel => used.Contains(channel.Id))))
            {
                file.Define(some);
            }

            file._chunks.Add(ChunkEntry.Of(chunk, file._position));
            file.Append(chunk);
        }

        using (var end = new McapRecord(McapOpcode.DataEnd))
        {
            file.Append(end.UInt32(file._crc).ToArray());
        }

        file.AppendSummary();
        file.Append(Magic.ToArray());
    }

    private static byte[] Header()
    {
        using var header = new McapRecord(McapOpcode.Header);
        return header.Text("").Text(Library).ToArray();
    }

    /// <summary>The channels that stand before a chunk.</summary>
    private static IEnumerable<McapChannel> ChannelsBefore(byte[] staged)
    {
        for (int at = 0; at < staged.Length && staged[at] == (byte)McapOpcode.Channel; at += ChunkEntry.LengthAt(staged, at))
        {
            yield return ChannelAt(staged, at);
        }
    }

    private static McapChannel ChannelAt(byte[] staged, int at)
    {
        try
        {
            return McapDefinitions.ChannelAt(staged, at);
        }
        catch (ArgumentException e)
        {
            throw ChunkEntry.Damaged(e);
        }
    }

    /// <summary>Defines the schemas, then the channels that are not defined yet.</summary>
    private void Define(IReadOnlyList<McapChannel> channels)
    {
        McapChannel[] more = [.. channels.Where(channel => _channels.TryAdd(channel.Id, channel))];
        foreach (string schema in more.Select(channel => channel.Schema).Where(name => _schemas.Add(McapDefinitions.NumberOf(name))))
        {
            Append(McapDefinitions.SchemaRecord(schema));
        }

        foreach (McapChannel channel in more)
        {
            Append(McapDefinitions.ChannelRecord(channel));
        }
    }

    /// <summary>Groups of records of one kind, the places of the groups, and the footer, which ends with the checksum of it all.</summary>
    private void AppendSummary()
    {
        long start = _position;
        _crc = 0;
        (McapOpcode Kind, long Start, long Length)[] groups =
        [
            Group(McapOpcode.Schema, _schemas.Select(number => McapDefinitions.SchemaRecord(MessageSchemas.Names[number - 1]))),
            Group(McapOpcode.Channel, _channels.Values.Select(McapDefinitions.ChannelRecord)),
            Group(McapOpcode.Statistics, [Statistics()]),
            Group(McapOpcode.ChunkIndex, _chunks.Select(chunk => chunk.Index())),
        ];
        long offsets = _position;
        foreach ((McapOpcode kind, long groupStart, long length) in groups.Where(group => group.Length > 0))
        {
            using var offset = new McapRecord(McapOpcode.SummaryOffset);
            Append(offset.Bytes([(byte)kind]).UInt64(groupStart).UInt64(length).ToArray());
        }

        using var footer = new McapRecord(McapOpcode.Footer);
        byte[] whole = footer.UInt64(start).UInt64(offsets).UInt32(0).ToArray();
        uint crc = Crc32.Append(_crc, whole, whole.Length - sizeof(uint));
        BitConverter.TryWriteBytes(whole.AsSpan(whole.Length - sizeof(uint)), crc);
        Append(whole);
    }

    private (McapOpcode Kind, long Start, long Length) Group(McapOpcode kind, IEnumerable<byte[]> records)
    {
        long start = _position;
        foreach (byte[] record in records)
        {
            Append(record);
        }

        return (kind, start, _position - start);
    }

    private byte[] Statistics()
    {
        using var statistics = new McapRecord(McapOpcode.Statistics);
        (int Channel, long Count)[] counts =
        [
            .. _chunks
                .SelectMany(chunk => chunk.Messages)
                .GroupBy(channel => channel)
                .OrderBy(group => group.Key)
                .Select(group => (group.Key, (long)group.Count())),
        ];
        return statistics
            .UInt64(counts.Sum(count => count.Count))
            .UInt16(_schemas.Count)
            .UInt32(_channels.Count)
            .UInt32(0)
            .UInt32(0)
            .UInt32(_chunks.Count)
            .UInt64(_chunks.Count == 0 ? 0 : _chunks.Min(chunk => chunk.Nanoseconds))
            .UInt64(_chunks.Count == 0 ? 0 : _chunks.Max(chunk => chunk.EndNanoseconds))
            .Entries(counts, OffsetBytes, count => statistics.UInt16(count.Channel).UInt64(count.Count))
            .ToArray();
    }

    private void Append(byte[] bytes)
    {
        _stream.Write(bytes);
        _position += bytes.Length;
        _crc = Crc32.Append(_crc, bytes, bytes.Length);
    }

    /// <summary>What the summary says of a chunk.</summary>
    private sealed record ChunkEntry(
        long Nanoseconds,
        long EndNanoseconds,
        long Start,
        long Length,
        long ContentLength,
        IReadOnlyList<(int Channel, long Start)> Indexes,
        long IndexLength,
        IReadOnlyList<int> Messages
    )
    {
        private const int IndexEntryBytes = 2 * sizeof(ulong);
        private const int EndAt = McapRecord.HeadLength + sizeof(ulong);
        private const int ContentLengthAt = McapRecord.HeadLength + (2 * sizeof(ulong));

        /// <summary>Reads what <see cref="McapChunk"/> has built.</summary>
        /// <exception cref="DatasetFormatException">It is damaged.</exception>
        public static ChunkEntry Of(byte[] records, long start)
        {
            try
            {
                int chunk = LengthAt(records, 0);
                var indexes = new List<(int Channel, long Start)>();
                var messages = new List<int>();
                for (int at = chunk; at < records.Length; at += LengthAt(records, at))
                {
                    int channel = BitConverter.ToUInt16(records, at + McapRecord.HeadLength);
                    indexes.Add((channel, start + at));
                    int entries = BitConverter.ToInt32(records, at + McapRecord.HeadLength + sizeof(ushort)) / IndexEntryBytes;
                    messages.AddRange(Enumerable.Repeat(channel, entries));
                }

                return new ChunkEntry(
                    BitConverter.ToInt64(records, McapRecord.HeadLength),
                    BitConverter.ToInt64(records, EndAt),
                    start,
                    chunk,
                    BitConverter.ToInt64(records, ContentLengthAt),
                    indexes,
                    records.Length - chunk,
                    messages
                );
            }
            catch (ArgumentException e)
            {
                throw Damaged(e);
            }
        }

        public static DatasetFormatException Damaged(Exception cause) =>
            new("A staged file of the export is damaged. Delete the folder and export again.", cause);

        public byte[] Index()
        {
            using var index = new McapRecord(McapOpcode.ChunkIndex);
            return index
                .UInt64(Nanoseconds)
                .UInt64(EndNanoseconds)
                .UInt64(Start)
                .UInt64(Length)
                .Entries(Indexes, OffsetBytes, entry => index.UInt16(entry.Channel).UInt64(entry.Start))
                .UInt64(IndexLength)
                .Text("")
                .UInt64(ContentLength)
                .UInt64(ContentLength)
                .ToArray();
        }

        /// <summary>The bytes of a record.</summary>
        /// <exception cref="ArgumentException">It is cut off.</exception>
        public static int LengthAt(byte[] records, int at)
        {
            int length = checked(McapRecord.HeadLength + (int)BitConverter.ToUInt64(records, at + 1));
            return length <= records.Length - at ? length : throw new ArgumentException("The record is cut off.", nameof(records));
        }
    }
}
