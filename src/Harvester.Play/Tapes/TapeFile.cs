using System.IO.Compression;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Play.Tapes;

/// <summary>Writes the chunks of a tape. After a crash the file can be read up to its last whole one.</summary>
/// <param name="create">Creates the file; called with the first chunk.</param>
public sealed class TapeFile(Func<Stream> create) : IDisposable
{
    private readonly RepeatPacker _repeats = new();
    private Stream? _file;
    private bool _hasFailed;

    /// <summary>Writes to a path, where there must be nothing yet; its folder is created.</summary>
    public TapeFile(string path)
        : this(() =>
        {
            Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            return new FileStream(path, FileMode.CreateNew, FileAccess.Write, FileShare.Read);
        }) { }

    /// <summary>
    /// Compresses and appends a chunk; returns the bytes appended. After a failure nothing more is appended, because the last chunk may be
    /// incomplete; a reader ignores that one.
    /// </summary>
    /// <exception cref="IOException">It cannot be written.</exception>
    public long Append(byte[] chunk)
    {
        if (chunk is null)
        {
            throw new ArgumentNullException(nameof(chunk));
        }

        if (_hasFailed)
        {
            return 0;
        }

        using var packed = new MemoryStream();
        packed.Write(new byte[TapeFormat.ChunkHeaderBytes], 0, TapeFormat.ChunkHeaderBytes);
        using (var deflate = new DeflateStream(packed, CompressionLevel.Optimal, leaveOpen: true))
        using (var buffer = new BufferedStream(deflate))
        {
            _repeats.Pack(chunk, buffer);
        }

        packed.Position = 0;
        using (var head = new BinaryWriter(packed, System.Text.Encoding.UTF8, leaveOpen: true))
        {
            head.Write((uint)(packed.Length - TapeFormat.ChunkHeaderBytes));
            head.Write((uint)chunk.Length);
            head.Write(Crc32.Append(0, chunk, chunk.Length));
        }

        _hasFailed = true;
        Stream file = _file ??= Create();
        packed.WriteTo(file);
        file.Flush();
        _hasFailed = false;
        return packed.Length;
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        _file?.Dispose();
        _file = null;
    }

    private Stream Create()
    {
        Stream file = create();
        file.Write(TapeFormat.Magic, 0, TapeFormat.Magic.Length);
        file.WriteByte(TapeFormat.Version);
        return file;
    }
}
