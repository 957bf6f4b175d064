using System.Buffers;
using System.Buffers.Binary;
using System.Buffers.Text;
using System.Text;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.Columns;

/// <summary>Reads the rows that <see cref="RowEncoder"/> wrote.</summary>
/// <param name="bytes">The rows.</param>
internal ref struct RowDecoder(ReadOnlySpan<byte> bytes)
{
    private ReadOnlySpan<byte> _rest = bytes;

    /// <summary>Rows from a line of a journal.</summary>
    /// <exception cref="DatasetFormatException">The line is damaged.</exception>
    public static RowDecoder Of(string part)
    {
        byte[] bytes = new byte[Base64Url.GetMaxDecodedLength(part.Length)];
        return Base64Url.DecodeFromChars(part, bytes, out _, out int length) == OperationStatus.Done
            ? new RowDecoder(bytes.AsSpan(0, length))
            : throw Damaged();
    }

    /// <summary>The error of a journal that is not as it was written.</summary>
    public static DatasetFormatException Damaged() =>
        new("A journal of the export has a damaged row. Delete the folder, and export again.");

    /// <summary>Whether all rows were read.</summary>
    public readonly bool IsAtEnd => _rest.IsEmpty;

    /// <summary>Whether the next value is known, and follows.</summary>
    public bool IsKnown() => Take(1)[0] != 0;

    /// <summary>The next byte as true or false.</summary>
    public bool Truth() => Take(1)[0] != 0;

    /// <summary>The next whole number of 32 bits.</summary>
    public int Integer() => BinaryPrimitives.ReadInt32LittleEndian(Take(sizeof(int)));

    /// <summary>The next whole number of 64 bits.</summary>
    public long Long() => BinaryPrimitives.ReadInt64LittleEndian(Take(sizeof(long)));

    /// <summary>The next number.</summary>
    public double Number() => BitConverter.Int64BitsToDouble(Long());

    /// <summary>The next text.</summary>
    public string Text() => Encoding.UTF8.GetString(Take(Integer()));

    private ReadOnlySpan<byte> Take(int length)
    {
        if (length < 0 || length > _rest.Length)
        {
            throw Damaged();
        }

        ReadOnlySpan<byte> taken = _rest[..length];
        _rest = _rest[length..];
        return taken;
    }
}
