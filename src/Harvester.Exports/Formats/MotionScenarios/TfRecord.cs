using System.Buffers.Binary;
using System.Numerics;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>
/// The frames of a TFRecord file: the length of the data as 8 bytes, little-endian, the masked CRC-32C of these, the data, and the masked
/// CRC-32C of the data.
/// </summary>
internal static class TfRecord
{
    /// <summary>Largest size of a record that is read, bytes: many times that of a scenario of WOMD.</summary>
    public const int MaxBytes = 8 << 20;

    private const int LengthBytes = sizeof(ulong);
    private const int CrcBytes = sizeof(uint);

    /// <summary>Added to a rotated checksum, so that checksums of data with checksums inside stay good.</summary>
    private const uint Mask = 0xa282ead8;
    private const int Rotation = 15;

    /// <summary>Writes a record.</summary>
    public static void Write(Stream stream, ReadOnlySpan<byte> data)
    {
        Span<byte> length = stackalloc byte[LengthBytes];
        Span<byte> crc = stackalloc byte[CrcBytes];
        BinaryPrimitives.WriteUInt64LittleEndian(length, (ulong)data.Length);
        BinaryPrimitives.WriteUInt32LittleEndian(crc, Checksum(length));
        stream.Write(length);
        stream.Write(crc);
        stream.Write(data);
        BinaryPrimitives.WriteUInt32LittleEndian(crc, Checksum(data));
        stream.Write(crc);
    }

    /// <summary>Reads the records of a file, one at a time.</summary>
    /// <exception cref="DatasetFormatException">The file is damaged, or a record too large; the message refers to the file as
    /// "it".</exception>
    public static IEnumerable<byte[]> Read(Stream stream)
    {
        var head = new byte[LengthBytes + CrcBytes];
        for (int number = 0; ; number++)
        {
            int got = stream.ReadAtLeast(head, head.Length, throwOnEndOfStream: false);
            if (got == 0)
            {
                yield break;
            }

            ulong length = BinaryPrimitives.ReadUInt64LittleEndian(head);
            if (
                got < head.Length
                || Checksum(head.AsSpan(0, LengthBytes)) != BinaryPrimitives.ReadUInt32LittleEndian(head.AsSpan(LengthBytes))
            )
            {
                throw new DatasetFormatException(
                    FormattableString.Invariant($"record {number} in it is damaged, or it is no TFRecord file without compression.")
                );
            }

            if (length > MaxBytes)
            {
                throw new DatasetFormatException(
                    FormattableString.Invariant($"record {number} in it has {length} bytes, more than {MaxBytes}, the limit.")
                );
            }

            var data = new byte[(int)length + CrcBytes];
            if (
                stream.ReadAtLeast(data, data.Length, throwOnEndOfStream: false) < data.Length
                || Checksum(data.AsSpan(0, (int)length)) != BinaryPrimitives.ReadUInt32LittleEndian(data.AsSpan((int)length))
            )
            {
                throw new DatasetFormatException(FormattableString.Invariant($"record {number} in it is cut off or damaged."));
            }

            yield return data[..(int)length];
        }
    }

    private static uint Checksum(ReadOnlySpan<byte> data)
    {
        uint crc = uint.MaxValue;
        foreach (byte value in data)
        {
            crc = BitOperations.Crc32C(crc, value);
        }

        crc = ~crc;
        return unchecked(((crc >> Rotation) | (crc << (sizeof(uint) * 8 - Rotation))) + Mask);
    }
}
