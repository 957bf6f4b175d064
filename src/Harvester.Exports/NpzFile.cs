using System.IO.Compression;
using System.Text;

namespace Harvester.Exports;

/// <summary>
/// Writes and reads NumPy's .npz files of one array: a ZIP archive with an .npy file (numpy.org, "NPY format", version 1.0).
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
        ZipArchiveEntry entry = archive.CreateEntry($"{name}.npy", CompressionLevel.NoCompression);
        entry.LastWriteTime = Time;
        using Stream file = entry.Open();
        file.Write(Header("<u2", $"({values.Length},)"));
        byte[] bytes = new byte[values.Length * sizeof(ushort)];
        for (int i = 0; i < values.Length; i++)
        {
            bytes[2 * i] = (byte)values[i];
            bytes[(2 * i) + 1] = (byte)(values[i] >> 8);
        }

        file.Write(bytes);
    }

    /// <summary>Reads what <see cref="Write"/> wrote.</summary>
    /// <param name="stream">The file.</param>
    /// <param name="name">Name of the array.</param>
    /// <param name="count">Number of values that it must have.</param>
    /// <returns>The values; null if it is another file.</returns>
    public static ushort[]? Read(Stream stream, string name, int count)
    {
        byte[] header = Header("<u2", $"({count},)");
        byte[] bytes = new byte[header.Length + (count * sizeof(ushort))];
        try
        {
            using var archive = new ZipArchive(stream, ZipArchiveMode.Read, leaveOpen: true);
            if (archive.GetEntry($"{name}.npy") is not { } entry || entry.Length != bytes.Length)
            {
                return null;
            }

            using Stream file = entry.Open();
            file.ReadExactly(bytes);
        }
        catch (Exception e) when (e is InvalidDataException or EndOfStreamException)
        {
            return null;
        }

        ushort[] values = new ushort[count];
        for (int i = 0; i < count; i++)
        {
            values[i] = (ushort)(bytes[header.Length + (2 * i)] | (bytes[header.Length + (2 * i) + 1] << 8));
        }

        return bytes.AsSpan(0, header.Length).SequenceEqual(header) ? values : null;
    }

    /// <summary>The head of the array: magic, length, and a Python dictionary, padded with blanks to whole blocks.</summary>
    private static byte[] Header(string type, string shape)
    {
        string text = $"{{'descr': '{type}', 'fortran_order': False, 'shape': {shape}, }}";
        int length = (HeadLength + text.Length + 1 + Alignment - 1) / Alignment * Alignment;
        string padded = text.PadRight(length - HeadLength - 1) + "\n";
        return [.. Magic, (byte)padded.Length, (byte)(padded.Length >> 8), .. Encoding.ASCII.GetBytes(padded)];
    }
}
