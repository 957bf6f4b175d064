using System.Text;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>
/// Builds one record of an MCAP file: a kind, the length of the content, and the content, all numbers with the lowest byte first
/// (mcap.dev/spec, "Serialization").
/// </summary>
internal sealed class McapRecord : IDisposable
{
    /// <summary>Bytes of a record before its content: kind and length.</summary>
    public const int HeadLength = 1 + sizeof(ulong);

    private readonly MemoryStream _bytes;
    private readonly BinaryWriter _writer;

    /// <summary>Begins a record.</summary>
    /// <param name="opcode">Its kind.</param>
    /// <param name="capacity">Number of bytes to make room for.</param>
    public McapRecord(McapOpcode opcode, int capacity = 0)
    {
        _bytes = new MemoryStream(capacity);
        _writer = new BinaryWriter(_bytes, Encoding.UTF8);
        _writer.Write((byte)opcode);
        _writer.Write(0UL);
    }

    public McapRecord UInt16(int value)
    {
        _writer.Write(checked((ushort)value));
        return this;
    }

    public McapRecord UInt32(long value)
    {
        _writer.Write(checked((uint)value));
        return this;
    }

    public McapRecord UInt64(long value)
    {
        _writer.Write(checked((ulong)value));
        return this;
    }

    public McapRecord Text(string text)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(text);
        return UInt32(bytes.Length).Bytes(bytes);
    }

    public McapRecord Bytes(ReadOnlySpan<byte> bytes)
    {
        _writer.Write(bytes);
        return this;
    }

    /// <summary>An array or a map: the number of its bytes, and its entries.</summary>
    public McapRecord Entries<T>(IReadOnlyCollection<T> entries, int bytesEach, Action<T> write)
    {
        UInt32((long)entries.Count * bytesEach);
        foreach (T entry in entries)
        {
            write(entry);
        }

        return this;
    }

    /// <summary>The whole record.</summary>
    public byte[] ToArray()
    {
        _writer.Flush();
        byte[] record = _bytes.ToArray();
        BitConverter.TryWriteBytes(record.AsSpan(1), (ulong)(record.Length - HeadLength));
        return record;
    }

    /// <summary>Writes the whole record to a stream, which for records with images is faster than a copy.</summary>
    public void WriteTo(Stream target)
    {
        _writer.Flush();
        byte[] record = _bytes.GetBuffer();
        BitConverter.TryWriteBytes(record.AsSpan(1), (ulong)(_bytes.Length - HeadLength));
        target.Write(record, 0, (int)_bytes.Length);
    }

    public void Dispose()
    {
        _writer.Dispose();
        _bytes.Dispose();
    }
}
