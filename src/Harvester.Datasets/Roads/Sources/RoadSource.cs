using System.IO.Compression;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Roads.Sources;

/// <summary>One file of road data: plain, gzip-compressed, or in a zip archive.</summary>
/// <param name="name">Name in messages.</param>
/// <param name="allowance">Limit of the total size of all files of the import.</param>
/// <param name="open">Opens the stored bytes.</param>
internal sealed class RoadSource(string name, ByteAllowance allowance, Func<Stream> open)
{
    /// <summary>Largest size of a file, bytes unpacked; the dump of the whole game has 147 million.</summary>
    public const long MaxFileBytes = 1L << 30;

    private const int HeadLength = 4096;

    private long _farthest;

    public string Name => name;

    /// <summary>Opens the unpacked bytes. Reading throws beyond <see cref="MaxFileBytes"/> and when the allowance is used up.</summary>
    /// <param name="limit">Checks the bytes; null for no check.</param>
    public Stream Open(IByteLimit? limit = null)
    {
        byte[] magic = new byte[2];
        using (Stream probe = open())
        {
            probe.ReadAtLeast(magic, magic.Length, throwOnEndOfStream: false);
        }

        Stream stored = open();
        Stream unpacked = magic is [0x1F, 0x8B] ? new GZipStream(stored, CompressionMode.Decompress) : stored;
        return new CountedStream(unpacked, Passed, limit);
    }

    /// <summary>Opens the unpacked bytes as text with limited line length.</summary>
    public TextReader OpenText() => new LimitedTextReader(new StreamReader(Open(), System.Text.Encoding.UTF8), name);

    /// <summary>A file is read more than once, but counts only once.</summary>
    private void Passed(long position)
    {
        if (position > MaxFileBytes)
        {
            throw new DatasetFormatException($"{name}: exceeds the unpacked-size limit of {MaxFileBytes} bytes.");
        }

        if (position > _farthest)
        {
            allowance.Use(name, position - _farthest);
            _farthest = position;
        }
    }

    /// <summary>The first bytes as text, without a byte order mark.</summary>
    public string Head()
    {
        using Stream stream = Open();
        byte[] head = new byte[HeadLength];
        int length = stream.ReadAtLeast(head, head.Length, throwOnEndOfStream: false);
        return System.Text.Encoding.UTF8.GetString(head, 0, length).TrimStart('\uFEFF');
    }
}
