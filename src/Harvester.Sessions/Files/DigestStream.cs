using System.Security.Cryptography;

namespace Harvester.Sessions.Files;

/// <summary>Passes on what is written to it, and counts and digests it.</summary>
public sealed class DigestStream : Stream
{
    private readonly Stream _target;
    private readonly HashAlgorithm _sha256 = SHA256.Create();
    private long _bytes;

    private DigestStream(Stream target) => _target = target;

    /// <inheritdoc />
    public override bool CanRead => false;

    /// <inheritdoc />
    public override bool CanSeek => false;

    /// <inheritdoc />
    public override bool CanWrite => true;

    /// <inheritdoc />
    public override long Length => _bytes;

    /// <inheritdoc />
    public override long Position
    {
        get => _bytes;
        set => throw new NotSupportedException();
    }

    /// <summary>Writes to a stream and returns the digest of what was written.</summary>
    /// <param name="target">Where to.</param>
    /// <param name="content">Writes the content to a stream that cannot seek, and leaves the stream open.</param>
    public static FileDigest Write(Stream target, Action<Stream> content)
    {
        using var stream = new DigestStream(target);
        content(stream);
        stream._sha256.TransformFinalBlock([], 0, 0);
        return new FileDigest(stream._bytes, FileDigest.Hex(stream._sha256.Hash!));
    }

    /// <inheritdoc />
    public override void Write(byte[] buffer, int offset, int count)
    {
        _target.Write(buffer, offset, count);
        _sha256.TransformBlock(buffer, offset, count, null, 0);
        _bytes += count;
    }

    /// <inheritdoc />
    public override void Flush() => _target.Flush();

    /// <inheritdoc />
    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    /// <inheritdoc />
    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    /// <inheritdoc />
    public override void SetLength(long value) => throw new NotSupportedException();

    /// <inheritdoc />
    protected override void Dispose(bool disposing)
    {
        if (disposing)
        {
            _sha256.Dispose();
        }

        base.Dispose(disposing);
    }
}
