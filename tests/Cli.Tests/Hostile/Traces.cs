using System.IO.Compression;
using System.Text;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>Words in all files below a folder: in names, in bytes, and in what gzip and zip files hold.</summary>
internal static class Traces
{
    private static readonly byte[] Gzip = [0x1F, 0x8B];
    private static readonly byte[] Zip = [(byte)'P', (byte)'K', 3, 4];

    /// <summary>Where the words are, as "file: word".</summary>
    public static IEnumerable<string> Of(string folder, params string[] words)
    {
        byte[][] sought = [.. words.SelectMany(word => new[] { Encoding.UTF8.GetBytes(word), Encoding.Unicode.GetBytes(word) })];
        foreach (string path in Directory.EnumerateFileSystemEntries(folder, "*", SearchOption.AllDirectories))
        {
            string name = Path.GetRelativePath(folder, path);
            byte[][] contents = [Encoding.UTF8.GetBytes(name), .. File.Exists(path) ? ContentsOf(File.ReadAllBytes(path)) : []];
            foreach (byte[] word in sought.Where(word => contents.Any(content => content.AsSpan().IndexOf(word) >= 0)))
            {
                yield return $"{name}: {Encoding.UTF8.GetString(word)}";
            }
        }
    }

    private static IEnumerable<byte[]> ContentsOf(byte[] bytes)
    {
        yield return bytes;
        if (bytes.AsSpan().StartsWith(Gzip))
        {
            using var unpacked = new GZipStream(new MemoryStream(bytes), CompressionMode.Decompress);
            foreach (byte[] inner in ContentsOf(All(unpacked)))
            {
                yield return inner;
            }
        }

        if (bytes.AsSpan().StartsWith(Zip))
        {
            using var archive = new ZipArchive(new MemoryStream(bytes));
            foreach (ZipArchiveEntry entry in archive.Entries)
            {
                using Stream unpacked = entry.Open();
                foreach (byte[] inner in ContentsOf(All(unpacked)))
                {
                    yield return inner;
                }
            }
        }
    }

    private static byte[] All(Stream stream)
    {
        using var bytes = new MemoryStream();
        stream.CopyTo(bytes);
        return bytes.ToArray();
    }
}
