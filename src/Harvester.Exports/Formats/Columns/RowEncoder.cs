using System.Buffers;
using System.Buffers.Binary;
using System.Buffers.Text;
using System.Text;
using System.Text.Json;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.Columns;

/// <summary>
/// Rows of a table as bytes, which wait in the journal of an export until the table is written: for each value a byte that is 0 if it is
/// unknown, then the value, little-endian, texts and lists after their length. <see cref="RowDecoder"/> reads them.
/// </summary>
internal sealed class RowEncoder
{
    private readonly ArrayBufferWriter<byte> _bytes = new(1024);

    /// <summary>Whether there are rows.</summary>
    public bool IsEmpty => _bytes.WrittenCount == 0;

    /// <summary>The rows as one line, in an alphabet that JSON does not escape.</summary>
    public string ToPart() => Base64Url.EncodeToString(_bytes.WrittenSpan);

    /// <summary>A whole number that is known.</summary>
    public void Integer(int value)
    {
        Known();
        Raw(value);
    }

    /// <summary>A text that is known.</summary>
    public void Text(string value)
    {
        Known();
        RawText(value);
    }

    /// <summary>A value of a label; one that is missing or null is unknown.</summary>
    /// <param name="kind">Type of its column.</param>
    /// <param name="value">The value.</param>
    /// <param name="column">Name of the column, for the error.</param>
    /// <exception cref="DatasetFormatException">It is not of this type.</exception>
    public void Value(ColumnKind kind, JsonElement value, string column)
    {
        if (value.ValueKind is JsonValueKind.Undefined or JsonValueKind.Null)
        {
            _bytes.GetSpan(1)[0] = 0;
            _bytes.Advance(1);
            return;
        }

        Known();
        if (!TryWrite(kind, value))
        {
            throw new DatasetFormatException(
                $"the value of '{column}' is {value.GetRawText()[..Math.Min(20, value.GetRawText().Length)]}, "
                    + "which its column cannot have. Run 'harvester validate'."
            );
        }
    }

    private bool TryWrite(ColumnKind kind, JsonElement value)
    {
        switch (kind)
        {
            case ColumnKind.Integer:
                return value.ValueKind == JsonValueKind.Number && value.TryGetInt32(out int whole) && Raw(whole);
            case ColumnKind.Long:
                return value.ValueKind == JsonValueKind.Number && value.TryGetInt64(out long wide) && Raw(wide);
            case ColumnKind.Number:
                return value.ValueKind == JsonValueKind.Number
                    && value.TryGetDouble(out double number)
                    && Raw(BitConverter.DoubleToInt64Bits(number));
            case ColumnKind.Truth:
                return value.ValueKind is JsonValueKind.True or JsonValueKind.False && RawByte((byte)(value.GetBoolean() ? 1 : 0));
            case ColumnKind.Text or ColumnKind.Word:
                return value.ValueKind == JsonValueKind.String && RawText(value.GetString()!);
            default:
                return value.ValueKind == JsonValueKind.Array && TryWriteList(kind, value);
        }
    }

    private bool TryWriteList(ColumnKind kind, JsonElement list)
    {
        ColumnKind item = ItemOf(kind);
        Raw(list.GetArrayLength());
        foreach (JsonElement value in list.EnumerateArray())
        {
            if (!TryWrite(item, value))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>The type of the items of a list.</summary>
    public static ColumnKind ItemOf(ColumnKind list) =>
        list switch
        {
            ColumnKind.Integers => ColumnKind.Integer,
            ColumnKind.Numbers => ColumnKind.Number,
            _ => ColumnKind.Text,
        };

    private void Known() => RawByte(1);

    private bool RawByte(byte value)
    {
        _bytes.GetSpan(1)[0] = value;
        _bytes.Advance(1);
        return true;
    }

    private bool Raw(int value)
    {
        BinaryPrimitives.WriteInt32LittleEndian(_bytes.GetSpan(sizeof(int)), value);
        _bytes.Advance(sizeof(int));
        return true;
    }

    private bool Raw(long value)
    {
        BinaryPrimitives.WriteInt64LittleEndian(_bytes.GetSpan(sizeof(long)), value);
        _bytes.Advance(sizeof(long));
        return true;
    }

    private bool RawText(string text)
    {
        int length = Encoding.UTF8.GetByteCount(text);
        Raw(length);
        _bytes.Advance(Encoding.UTF8.GetBytes(text, _bytes.GetSpan(length)));
        return true;
    }
}
