using System.Text;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.Columns;

/// <summary>
/// Reads Thrift's compact protocol (https://github.com/apache/thrift/blob/master/doc/specs/thrift-compact-protocol.md), in which a Parquet
/// file describes itself. Nothing is allocated on the word of a length that the bytes do not bear out.
/// </summary>
/// <param name="bytes">The bytes.</param>
internal ref struct ThriftReader(ReadOnlySpan<byte> bytes)
{
    private const int MaxDepth = 16;
    private const int MaxVarintBytes = 10;

    /// <summary>The footer of the objects of ten million frames has fewer; each is held.</summary>
    private const int MaxValues = 8_000_000;

    private readonly ReadOnlySpan<byte> _bytes = bytes;
    private int _values;

    /// <summary>Number of bytes read.</summary>
    public int Position { get; private set; }

    /// <summary>Reads a structure.</summary>
    /// <exception cref="DatasetFormatException">The bytes are not one.</exception>
    public ThriftStruct Struct() => Struct(0);

    private ThriftStruct Struct(int depth)
    {
        var fields = new Dictionary<int, object>();
        int last = 0;
        while (Byte() is var head and not 0)
        {
            // The upper half is the distance from the number of the field before, or 0 if the number follows.
            last = head >> 4 == 0 ? (int)Signed() : last + (head >> 4);
            fields[last] = (head & 0xF) switch
            {
                1 => true,
                2 => false,
                var type => Value(type, depth),
            };
        }

        return new ThriftStruct(fields);
    }

    private object Value(int type, int depth)
    {
        if (depth > MaxDepth || ++_values > MaxValues)
        {
            throw new DatasetFormatException("its footer is nested too deeply, or has too many values.");
        }

        switch (type)
        {
            case 1 or 2:
                return Byte() == 1;
            case 3:
                return (long)Byte();
            case 4 or 5 or 6:
                return Signed();
            case 7:
                Take(sizeof(double));
                return 0.0;
            case 8:
                return Encoding.UTF8.GetString(Take(Varint()));
            case 9 or 10:
                return List(depth);
            case 12:
                return Struct(depth + 1);
            default:
                throw new DatasetFormatException($"its footer has a field of the unknown type {type}.");
        }
    }

    private List<object> List(int depth)
    {
        int head = Byte();
        ulong count = head >> 4 == 15 ? Varint() : (ulong)(head >> 4);
        var items = new List<object>();
        for (ulong i = 0; i < count; i++)
        {
            // Every item takes a byte at least, so a wrong number runs into the end.
            items.Add(Value(head & 0xF, depth + 1));
        }

        return items;
    }

    /// <summary>Signed numbers are written as 2 n if not negative, otherwise as -2 n - 1.</summary>
    private long Signed()
    {
        ulong raw = Varint();
        return (long)(raw >> 1) ^ -(long)(raw & 1);
    }

    private ulong Varint()
    {
        ulong value = 0;
        for (int i = 0; i < MaxVarintBytes; i++)
        {
            int part = Byte();
            value |= (ulong)(part & 0x7F) << (7 * i);
            if ((part & 0x80) == 0)
            {
                return value;
            }
        }

        throw new DatasetFormatException("its footer has a number that is too long.");
    }

    private int Byte() => Take(1)[0];

    private ReadOnlySpan<byte> Take(ulong length)
    {
        if (length > (ulong)(_bytes.Length - Position))
        {
            throw new DatasetFormatException("its footer or a page is cut off.");
        }

        ReadOnlySpan<byte> taken = _bytes.Slice(Position, (int)length);
        Position += (int)length;
        return taken;
    }
}
