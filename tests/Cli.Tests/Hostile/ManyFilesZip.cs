using System.Globalization;
using System.IO.Compression;
using System.Text;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>
/// A zip archive of very many files with the same content, in the form that more than 65,535 need (Zip64; APPNOTE 6.3.10, sections 4.3.7
/// to 4.3.16). ZipArchive takes minutes to write one.
/// </summary>
internal static class ManyFilesZip
{
    private const ushort Version = 45;

    public static void Write(string path, int files, string text)
    {
        byte[] content = Encoding.ASCII.GetBytes(text);
        uint checksum = ChecksumOf(content);
        var length = (uint)content.Length;
        using var writer = new BinaryWriter(File.Create(path));
        long[] places = new long[files];
        for (int i = 0; i < files; i++)
        {
            places[i] = writer.BaseStream.Position;
            byte[] name = NameOf(i);
            WriteFields(writer, 0x04034b50u, Version, (ushort)0, (ushort)0, 0u, checksum, length, length, (ushort)name.Length, (ushort)0);
            writer.Write(name);
            writer.Write(content);
        }

        long directory = writer.BaseStream.Position;
        for (int i = 0; i < files; i++)
        {
            byte[] name = NameOf(i);
            WriteFields(writer, 0x02014b50u, Version, Version, (ushort)0, (ushort)0, 0u, checksum, length, length);
            WriteFields(writer, (uint)name.Length, 0u, 0u, (ushort)0, (uint)places[i]);
            writer.Write(name);
        }

        long end = writer.BaseStream.Position;
        WriteFields(writer, 0x06064b50u, 44L, Version, Version, 0u, 0u, (long)files, (long)files, end - directory, directory);
        WriteFields(writer, 0x07064b50u, 0u, end, 1u);
        WriteFields(writer, 0x06054b50u, 0u, uint.MaxValue, uint.MaxValue, uint.MaxValue, (ushort)0);
    }

    private static byte[] NameOf(int file) => Encoding.ASCII.GetBytes(string.Create(CultureInfo.InvariantCulture, $"{file}.csv"));

    private static uint ChecksumOf(byte[] content)
    {
        using var stream = new MemoryStream();
        using (var archive = new ZipArchive(stream, ZipArchiveMode.Create, leaveOpen: true))
        {
            using Stream entry = archive.CreateEntry("0").Open();
            entry.Write(content);
        }

        using var written = new ZipArchive(stream, ZipArchiveMode.Read);
        return written.Entries[0].Crc32;
    }

    private static void WriteFields(BinaryWriter writer, params ReadOnlySpan<object> fields)
    {
        foreach (object field in fields)
        {
            switch (field)
            {
                case ushort value:
                    writer.Write(value);
                    break;
                case uint value:
                    writer.Write(value);
                    break;
                default:
                    writer.Write((long)field);
                    break;
            }
        }
    }
}
