using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>Reads an MCAP file that this program wrote, from its start to its end, and compares all that it says twice.</summary>
/// <param name="file">The file, at its start.</param>
internal sealed class McapReader(Stream file)
{
    private const int MaxRecordBytes = 1 << 28;
    private const int IndexEntryBytes = 2 * sizeof(ulong);
    private const int OffsetEntryBytes = sizeof(ushort) + sizeof(ulong);
    private const int MessageHeadBytes = sizeof(ushort) + sizeof(uint) + (2 * sizeof(ulong));

    private readonly Dictionary<long, int> _chunks = [];
    private readonly Dictionary<long, int> _indexes = [];
    private readonly Dictionary<int, long> _messages = [];
    private readonly Dictionary<int, string> _schemas = [];
    private readonly Dictionary<int, McapChannel> _channels = [];
    private byte[]? _chunk;
    private uint _crc;
    private long _summaryStart = -1;
    private bool _isEnded;
    private long _indexedChunks;

    /// <summary>Reads the file.</summary>
    /// <returns>Number of images.</returns>
    /// <exception cref="DatasetFormatException">Something is wrong; the message says what.</exception>
    /// <exception cref="EndOfStreamException">The file is cut off.</exception>
    public int CountImages()
    {
        Magic();
        while (!_isEnded)
        {
            Record();
        }

        Magic();
        return file.ReadByte() != -1 ? throw new DatasetFormatException("something follows its end.")
            : _indexedChunks != _chunks.Count ? throw new DatasetFormatException("its summary does not list every chunk once.")
            : checked((int)_channels.Values.Where(IsOfImages).Sum(channel => _messages.GetValueOrDefault(channel.Id)));
    }

    private void Magic()
    {
        byte[] magic = Read(McapFile.Magic.Length);
        if (!McapFile.Magic.SequenceEqual(magic))
        {
            throw new DatasetFormatException("it does not begin and end like an MCAP file.");
        }
    }

    private void Record()
    {
        long start = file.Position;
        uint before = _crc;
        byte[] head = Read(McapRecord.HeadLength);
        ulong length = BitConverter.ToUInt64(head, 1);
        if (length > MaxRecordBytes)
        {
            throw new DatasetFormatException($"a record has {length} bytes; {MaxRecordBytes} is the limit.");
        }

        if ((long)length > file.Length - file.Position)
        {
            throw new EndOfStreamException();
        }

        var kind = (McapOpcode)head[0];
        uint beforeContent = _crc;
        byte[] content = Read((int)length);
        try
        {
            switch (kind)
            {
                case McapOpcode.Chunk:
                    _chunks[start] = content.Length + McapRecord.HeadLength;
                    _chunk = ChunkContent(content);
                    CountMessages(_chunk);
                    break;
                case McapOpcode.MessageIndex:
                    _indexes[start] = BitConverter.ToUInt16(content);
                    Index(content);
                    break;
                case McapOpcode.DataEnd:
                    Expect(BitConverter.ToUInt32(content) == before, "the checksum of its data is wrong.");
                    (_summaryStart, _crc) = (file.Position, 0);
                    break;
                case McapOpcode.ChunkIndex:
                    ChunkIndex(content);
                    break;
                case McapOpcode.Footer:
                    uint crc = Crc32.Append(beforeContent, content, content.Length - sizeof(uint));
                    Expect(BitConverter.ToUInt32(content, content.Length - sizeof(uint)) == crc, "the checksum of its summary is wrong.");
                    Expect(BitConverter.ToInt64(content) == _summaryStart, "its footer does not name the start of the summary.");
                    _isEnded = true;
                    break;
                case McapOpcode.Schema:
                    _schemas[BitConverter.ToUInt16(content)] = McapDefinitions.Utf8(content, sizeof(ushort));
                    break;
                case McapOpcode.Channel:
                    Channel(content);
                    break;
                case McapOpcode.Header or McapOpcode.Statistics or McapOpcode.SummaryOffset:
                    break;
                default:
                    throw new DatasetFormatException($"it has a record of the unknown kind {head[0]}.");
            }
        }
        catch (Exception e) when (e is ArgumentException or IndexOutOfRangeException or OverflowException)
        {
            throw new DatasetFormatException($"its record {kind} at byte {start} is damaged.", e);
        }
    }

    private static byte[] ChunkContent(byte[] chunk)
    {
        const int crcAt = 3 * sizeof(ulong);
        int compression = BitConverter.ToInt32(chunk, crcAt + sizeof(uint));
        Expect(compression == 0, "a chunk is compressed, which this format is not.");
        int at = crcAt + (2 * sizeof(uint)) + sizeof(ulong);
        byte[] content = chunk[at..];
        Expect(
            BitConverter.ToInt64(chunk, at - sizeof(ulong)) == content.Length
                && BitConverter.ToInt64(chunk, 2 * sizeof(ulong)) == content.Length
                && BitConverter.ToUInt32(chunk, crcAt) == Crc32.Append(0, content, content.Length),
            "the length or the checksum of a chunk is wrong."
        );
        return content;
    }

    private void CountMessages(byte[] content)
    {
        for (long at = 0; at < content.Length; )
        {
            long length = BitConverter.ToInt64(content, (int)at + 1);
            Expect(
                content[at] == (byte)McapOpcode.Message
                    && length >= MessageHeadBytes
                    && length <= content.Length - at - McapRecord.HeadLength,
                "a chunk has something other than whole messages."
            );
            int channel = BitConverter.ToUInt16(content, (int)at + McapRecord.HeadLength);
            _messages[channel] = _messages.GetValueOrDefault(channel) + 1;
            Expect(_channels.TryGetValue(channel, out McapChannel? known), "a message is of a channel that is not defined before it.");
            if (IsOfImages(known!))
            {
                CheckImage(known!, content, (int)at + McapRecord.HeadLength + MessageHeadBytes, (int)length - MessageHeadBytes);
            }

            at += McapRecord.HeadLength + length;
        }
    }

    private static bool IsOfImages(McapChannel channel) => channel.Schema == McapChannel.Image.Schema;

    private void Channel(byte[] content)
    {
        int id = BitConverter.ToUInt16(content);
        Expect(
            _schemas.TryGetValue(BitConverter.ToUInt16(content, sizeof(ushort)), out string? schema),
            "a channel has a schema that is not defined before it."
        );
        _channels[id] = new McapChannel(id, McapDefinitions.Utf8(content, 2 * sizeof(ushort)), schema!);
    }

    private void CheckImage(McapChannel channel, byte[] content, int start, int length)
    {
        try
        {
            ImageMessage.Check(content, start, length);
        }
        catch (DatasetFormatException e)
        {
            string place = channel == McapChannel.Image ? "" : $"{channel.Topic}, ";
            throw new DatasetFormatException($"{place}image {_messages[channel.Id]}: {e.Message}", e);
        }
    }

    /// <summary>Every entry leads to a message of its channel and time in the chunk before.</summary>
    private void Index(byte[] index)
    {
        const int timeAt = McapRecord.HeadLength + sizeof(ushort) + sizeof(uint);
        const int entriesAt = sizeof(ushort) + sizeof(uint);
        Expect(_chunk is not null && index.Length == entriesAt + BitConverter.ToInt32(index, sizeof(ushort)), "an index is cut off.");
        for (int at = entriesAt; at < index.Length; at += IndexEntryBytes)
        {
            int offset = checked((int)BitConverter.ToInt64(index, at + sizeof(ulong)));
            Expect(
                BitConverter.ToUInt16(_chunk!, offset + McapRecord.HeadLength) == BitConverter.ToUInt16(index)
                    && BitConverter.ToInt64(_chunk!, offset + timeAt) == BitConverter.ToInt64(index, at),
                "an index leads to another message."
            );
        }
    }

    private void ChunkIndex(byte[] index)
    {
        const int startAt = 2 * sizeof(ulong);
        const int offsetsAt = 4 * sizeof(ulong);
        long start = BitConverter.ToInt64(index, startAt);
        Expect(
            _chunks.TryGetValue(start, out int length) && length == BitConverter.ToInt64(index, startAt + sizeof(ulong)),
            "its summary names a chunk that is not there."
        );
        int end = checked(offsetsAt + sizeof(uint) + BitConverter.ToInt32(index, offsetsAt));
        for (int at = offsetsAt + sizeof(uint); at < end; at += OffsetEntryBytes)
        {
            Expect(
                _indexes.TryGetValue(BitConverter.ToInt64(index, at + sizeof(ushort)), out int channel)
                    && channel == BitConverter.ToUInt16(index, at),
                "its summary names an index that is not there."
            );
        }

        _indexedChunks++;
    }

    private byte[] Read(int length)
    {
        byte[] bytes = new byte[length];
        file.ReadExactly(bytes);
        _crc = Crc32.Append(_crc, bytes, length);
        return bytes;
    }

    private static void Expect(bool isRight, string otherwise)
    {
        if (!isRight)
        {
            throw new DatasetFormatException(otherwise);
        }
    }
}
