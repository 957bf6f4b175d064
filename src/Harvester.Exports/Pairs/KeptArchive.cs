using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Pairs;

/// <summary>An archive that an earlier run has written, compared with what would be written, entry by entry.</summary>
internal sealed class KeptArchive : IDisposable
{
    /// <summary>An archive ends with two empty blocks of 512 bytes.</summary>
    public const int EndBytes = 1024;

    private readonly FileStream _stream;
    private long _good;

    private KeptArchive(string file) => _stream = InputFile.OpenRead(file);

    /// <summary>Opens an archive, or returns null if the file does not exist.</summary>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static KeptArchive? Open(string file) =>
        File.Exists(file) && new FileInfo(file).LinkTarget is null ? new KeptArchive(file) : null;

    /// <summary>Whether the next bytes are these.</summary>
    public bool Has(ReadOnlySpan<byte> bytes)
    {
        byte[] found = new byte[bytes.Length];
        if (_stream.ReadAtLeast(found, found.Length, throwOnEndOfStream: false) < found.Length || !bytes.SequenceEqual(found))
        {
            return false;
        }

        _good += bytes.Length;
        return true;
    }

    /// <summary>Whether the archive ends after what was found.</summary>
    public bool IsAtEnd() => _stream.Length == _good + EndBytes && Has(new byte[EndBytes]);

    /// <summary>Copies what was found as it should be.</summary>
    public void CopyTo(Stream target)
    {
        _stream.Position = 0;
        byte[] buffer = new byte[1 << 16];
        for (long left = _good; left > 0; )
        {
            int count = (int)Math.Min(left, buffer.Length);
            _stream.ReadExactly(buffer, 0, count);
            target.Write(buffer, 0, count);
            left -= count;
        }
    }

    /// <inheritdoc/>
    public void Dispose() => _stream.Dispose();
}
