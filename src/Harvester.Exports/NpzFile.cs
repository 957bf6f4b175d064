using System.IO.Compression;
using System.Text;

namespace Harvester.Exports;

/// <summary>
/// Writes and reads NumPy's .npz files: a ZIP archive with an .npy file for each array (numpy.org, "NPY format", version 1.0).
/// </summary>
internal static class NpzFile
{
    private const int Alignment = 64;
    private const int HeadLength = 10;

    /// <summary>The first time that a ZIP archive can have, for the same bytes every time.</summary>
    private static readonly DateTimeOffset Time = new(1980, 1, 1, 0, 0, 0, TimeSpan.Zero);

    private static ReadOnlySpan<byte> Magic => [0x93, (byte)'N', (byte)'U', (byte)'M', (byte)'P', (byte)'Y', 1, 0];

    /// <summary>Writes an array of one dimension.</summary>
    /// <param name="stream">Where to.</param>
    /// <param name="name">Its name.</param>
    /// <param name="values">The values, unsigned 16-bit.</param>
    public static void Write(Stream stream, string name, ReadOnlySpan<ushort> values)
    {
        using var archive = new ZipArchive(stream, ZipArchiveMode.Create, leaveOpen: true);
        byte[] bytes = new byte[values.Length * sizeof(ushort)];
        for (int i = 0; i < values.Length; i++)
        {
            bytes[2 * i] = (byte)values[i];
            bytes[(2 * i) + 1] = (byte)(values[i] >> 8);
        }

        Write(archive, name, CompressionLevel.NoCompression, Header("<u2", $"({values.Length},)"), bytes);
    }

    /// <summary>Writes compressed arrays of unsigned 8-bit numbers.</summary>
    /// <param name="stream">Where to.</param>
    /// <param name="shape">The lengths of the axes of each; the last one changes fastest.</param>
    /// <param name="arrays">Their names and values.</param>
    public static void Write(Stream stream, IReadOnlyList<int> shape, params ReadOnlySpan<(string Name, byte[] Values)> arrays)
    {
        using var archive = new ZipArchive(stream, ZipArchiveMode.Create, leaveOpen: true);
        foreach ((string name, byte[] values) in arrays)
        {
            Write(archive, name, CompressionLevel.Optimal, Header("|u1", TextOf(shape)), values);
        }
    }

    /// <summary>Reads arrays of unsigned 8-bit numbers.</summary>
    /// <param name="stream">The file.</param>
    /// <param name="shape">The lengths of the axes that each must have.</param>
    /// <param name="names">Names of the arrays.</param>
    /// <returns>Their values; null if it is another file.</returns>
    public static byte[][]? Read(Stream stream, IReadOnlyList<int> shape, params IReadOnlyList<string> names)
    {
        byte[] header = Header("|u1", TextOf(shape));
        int count = shape.Aggregate(static (product, length) => product * length);
        try
        {
            using var archive = new ZipArchive(stream, ZipArchiveMode.Read, leaveOpen: true);
            byte[]?[] arrays = [.. names.Select(name => Read(archive, name, header, count))];
            return Array.TrueForAll(arrays, static array => array is not null) ? [.. arrays.OfType<byte[]>()] : null;
        }
        catch (Exception e) when (e is InvalidDataException or EndOfStreamException)
        {
            return null;
        }
    }

    /// <summary>Reads what <see cref="Write(Stream, string, ReadOnlySpan{ushort})"/> wrote.</summary>
    /// <param name="stream">The file.</param>
    /// <param name="name">Name of the array.</param>
    /// <param name="count">Number of values that it must have.</param>
    /// <returns>The values; null if it is another file.</returns>
    public static ushort[]? Read(Stream stream, string name, int count)
    {
        byte[] header = Header("<u2", $"({count},)");
        try
        {
            using var archive = new ZipArchive(stream, ZipArchiveMode.Read, leaveOpen: true);
            if (Read(archive, name, header, count * sizeof(ushort)) is not { } bytes)
            {
                return null;
            }

            ushort[] values = new ushort[count];
            for (int i = 0; i < count; i++)
            {
                values[i] = (ushort)(bytes[2 * i] | (bytes[(2 * i) + 1] << 8));
            }

            return values;
        }
        catch (Exception e) when (e is InvalidDataException or EndOfStreamException)
        {
            return null;
        }
    }

    private static void Write(ZipArchive archive, string name, CompressionLevel level, byte[] header, byte[] bytes)
    {
        ZipArchiveEntry entry = archive.CreateEntry($"{name}.npy", level);
        entry.LastWriteTime = Time;
        using Stream file = entry.Open();
        file.Write(header);
        file.Write(bytes);
    }

    /// <summary>The bytes of an array; null if it is missing or has another header or length.</summary>
    private static byte[]? Read(ZipArchive archive, string name, byte[] header, int length)
    {
        byte[] bytes = new byte[header.Length + length];
        if (archive.GetEntry($"{name}.npy") is not { } entry || entry.Length != bytes.Length)
        {
            return null;
        }

        using Stream file = entry.Open();
        file.ReadExactly(bytes);
        return bytes.AsSpan(0, header.Length).SequenceEqual(header) ? bytes[header.Length..] : null;
    }

    private static string TextOf(IReadOnlyList<int> shape) => $"({string.Join(", ", shape.Select(Numbers.Text))})";

    /// <summary>The head of the array: magic, length, and a Python dictionary, padded with blanks to whole blocks.</summary>
    private static byte[] Header(string type, string shape)
    {
        string text = $"{{'descr': '{type}', 'fortran_order': False, 'shape': {shape}, }}";
        int length = (HeadLength + text.Length + 1 + Alignment - 1) / Alignment * Alignment;
        string padded = text.PadRight(length - HeadLength - 1) + "\n";
        return [.. Magic, (byte)padded.Length, (byte)(padded.Length >> 8), .. Encoding.ASCII.GetBytes(padded)];
    }
}
