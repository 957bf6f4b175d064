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
    private readonly HashSet<McapDefinitions> _defined = [];

    private McapFile(Stream stream) => _stream = stream;

    /// <summary>The bytes at both ends of a file.</summary>
    public static ReadOnlySpan<byte> Magic => [0x89, (byte)'M', (byte)'C', (byte)'A', (byte)'P', (byte)'0', (byte)'\r', (byte)'\n'];

    /// <summary>Writes a file.</summary>
    /// <param name="stream">Where to.</param>
    /// <param name="chunks">The chunks with their indexes, from <see cref="McapChunk"/>, by rising time.</param>
    public static void Write(Stream stream, IEnumerable<byte[]> chunks)
    {
        var file = new McapFile(stream);
        file.Append(Magic.ToArray());
        file.Append(Header());
        file.Define(McapDefinitions.OfSessions);
        foreach (byte[] chunk in chunks)
        {
            ChunkEntry entry = ChunkEntry.Of(chunk, file._position);

            // The channels that only some files have are defined where they are first used, because only the chunks tell of them.
            foreach (McapDefinitions some in McapDefinitions.OfSome.Where(some => entry.Messages.Any(some.Has)))
            {
                if (file._defined.Add(some))
                {
                    file.Define(some);
                    entry = ChunkEntry.Of(chunk, file._position);
                }
            }

            file._chunks.Add(entry);
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

    /// <summary>Defines schemas, then channels.</summary>
    private void Define(McapDefinitions definitions)
    {
        Append(definitions.SchemaRecords());
        Append(definitions.ChannelRecords());
    }

    /// <summary>Groups of records of one kind, the places of the groups, and the footer, which ends with the checksum of it all.</summary>
    private void AppendSummary()
    {
        long start = _position;
        _crc = 0;
        McapDefinitions definitions = McapDefinitions
            .OfSome.Where(_defined.Contains)
            .Aggregate(McapDefinitions.OfSessions, static (all, some) => all.With(some));
        (McapOpcode Kind, long Start, long Length)[] groups =
        [
            Group(McapOpcode.Schema, [definitions.SchemaRecords()]),
            Group(McapOpcode.Channel, [definitions.ChannelRecords()]),
            Group(McapOpcode.Statistics, [Statistics(definitions)]),
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

    private byte[] Statistics(McapDefinitions definitions)
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
            .UInt16(definitions.Schemas.Count)
            .UInt32(definitions.Channels.Count)
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
                throw new DatasetFormatException("A staged file of the export is damaged. Delete the folder and export again.", e);
            }
        }

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

        private static int LengthAt(byte[] records, int at)
        {
            int length = checked(McapRecord.HeadLength + (int)BitConverter.ToUInt64(records, at + 1));
            return length <= records.Length - at ? length : throw new ArgumentException("The record is cut off.", nameof(records));
        }
    }
}
