using System.IO.Compression;

namespace Harvester.Sessions.Imaging.Pictures;

/// <summary>
/// Writes one zlib stream (RFC 1950). At the fastest level it looks for runs only, if the runtime supports that: filtered images have
/// little else to find, and this gives fewer bytes in less time.
/// </summary>
internal sealed class ZlibWriter : IDisposable
{
#if NET
    private readonly ZLibStream _zlib;

    private static readonly ZLibCompressionOptions Runs = new()
    {
        CompressionLevel = 1,
        CompressionStrategy = ZLibCompressionStrategy.RunLengthEncoding,
    };

    public ZlibWriter(Stream target, CompressionLevel level) =>
        _zlib =
            level == CompressionLevel.Fastest
                ? new ZLibStream(target, Runs, leaveOpen: true)
                : new ZLibStream(target, level, leaveOpen: true);

    public void Write(byte[] bytes, int count) => _zlib.Write(bytes, 0, count);

    public void Dispose() => _zlib.Dispose();
#else
    /// <summary>Deflate, window of 32 KiB, fastest level: 0x7801 is a multiple of 31, as RFC 1950 requires.</summary>
    private static readonly byte[] Header = [0x78, 0x01];

    private readonly Adler32 _checksum = new();
    private readonly Stream _target;
    private readonly DeflateStream _deflate;

    public ZlibWriter(Stream target, CompressionLevel level)
    {
        _target = target;
        target.Write(Header, 0, Header.Length);
        _deflate = new DeflateStream(target, level, leaveOpen: true);
    }

    public void Write(byte[] bytes, int count)
    {
        _checksum.Append(bytes, count);
        _deflate.Write(bytes, 0, count);
    }

    public void Dispose()
    {
        _deflate.Dispose();
        uint sum = _checksum.Value;
        _target.Write([(byte)(sum >> 24), (byte)(sum >> 16), (byte)(sum >> 8), (byte)sum], 0, sizeof(uint));
    }
#endif
}
