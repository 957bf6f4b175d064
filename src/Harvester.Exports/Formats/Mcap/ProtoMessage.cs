using Google.Protobuf;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>
/// Writes the fields of a protobuf message by their numbers. As proto3 requires, numbers that are 0 and empty texts are left out.
/// </summary>
internal sealed class ProtoMessage : IDisposable
{
    private readonly MemoryStream _bytes;
    private readonly CodedOutputStream _output;

    // Messages within this one are written one after another, thousands in a frame with lanes, so one buffer serves them all.
    private ProtoMessage? _inner;

    private ProtoMessage(int capacity)
    {
        _bytes = new MemoryStream(capacity);
        _output = new CodedOutputStream(_bytes);
    }

    /// <summary>The bytes of a message.</summary>
    /// <param name="write">Writes the message.</param>
    /// <param name="capacity">Number of bytes to make room for.</param>
    public static byte[] Of(Action<ProtoMessage> write, int capacity = 0)
    {
        using var message = new ProtoMessage(capacity);
        write(message);
        message._output.Flush();
        return message._bytes.ToArray();
    }

    public void Dispose()
    {
        _inner?.Dispose();
        _output.Dispose();
        _bytes.Dispose();
    }

    public ProtoMessage Number(int field, double value) => value == 0 ? this : NumberOrZero(field, value);

    /// <summary>A number whose presence says something, even if it is 0.</summary>
    public ProtoMessage NumberOrZero(int field, double value)
    {
        _output.WriteTag(field, WireFormat.WireType.Fixed64);
        _output.WriteDouble(value);
        return this;
    }

    /// <summary>Numbers as one packed field.</summary>
    public ProtoMessage Numbers(int field, IReadOnlyCollection<double> values)
    {
        _output.WriteTag(field, WireFormat.WireType.LengthDelimited);
        _output.WriteLength(values.Count * sizeof(double));
        foreach (double value in values)
        {
            _output.WriteDouble(value);
        }

        return this;
    }

    public ProtoMessage Fixed32(int field, int value)
    {
        _output.WriteTag(field, WireFormat.WireType.Fixed32);
        _output.WriteFixed32(checked((uint)value));
        return this;
    }

    /// <summary>An integer, a boolean or a member of an enumeration.</summary>
    public ProtoMessage Integer(int field, long value)
    {
        if (value != 0)
        {
            _output.WriteTag(field, WireFormat.WireType.Varint);
            _output.WriteInt64(value);
        }

        return this;
    }

    public ProtoMessage Text(int field, string text)
    {
        if (text.Length > 0)
        {
            _output.WriteTag(field, WireFormat.WireType.LengthDelimited);
            _output.WriteString(text);
        }

        return this;
    }

    public ProtoMessage Bytes(int field, ReadOnlyMemory<byte> bytes)
    {
        _output.WriteTag(field, WireFormat.WireType.LengthDelimited);
        _output.WriteBytes(UnsafeByteOperations.UnsafeWrap(bytes));
        return this;
    }

    public ProtoMessage Message(int field, Action<ProtoMessage> write)
    {
        _inner ??= new ProtoMessage(0);
        _inner._bytes.SetLength(0);
        write(_inner);
        _inner._output.Flush();
        return Bytes(field, _inner._bytes.GetBuffer().AsMemory(0, (int)_inner._bytes.Length));
    }

    public ProtoMessage Messages<T>(int field, IEnumerable<T> items, Action<ProtoMessage, T> write)
    {
        foreach (T item in items)
        {
            Message(field, message => write(message, item));
        }

        return this;
    }
}
