using System.Buffers.Binary;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading.Images;

/// <summary>The compressed data of a PNG file: the content of its IDAT chunks, read on demand.</summary>
/// <param name="file">The file, positioned after its signature.</param>
internal sealed class PngData(Stream file) : Stream
{
    private const int ChecksumLength = 4;
    private const int HeadLength = 8;

    private long _left;
    private bool _isAtEnd;

    public override bool CanRead => true;

    public override bool CanSeek => false;

    public override bool CanWrite => false;

    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    /// <exception cref="DatasetFormatException">A chunk is longer than the file.</exception>
    public override int Read(Span<byte> buffer)
    {
        while (_left == 0 && !_isAtEnd)
        {
            FindData();
        }

        int read = _isAtEnd ? 0 : file.Read(buffer[..(int)Math.Min(buffer.Length, _left)]);
        _left -= read;
        if (_left == 0 && read > 0)
        {
            file.Seek(ChecksumLength, SeekOrigin.Current);
        }

        return read;
    }

    public override int Read(byte[] buffer, int offset, int count) => Read(buffer.AsSpan(offset, count));

    public override void Flush() { }

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    /// <summary>Skips chunks up to the next one with data.</summary>
    private void FindData()
    {
        Span<byte> head = stackalloc byte[HeadLength];
        if (file.ReadAtLeast(head, HeadLength, throwOnEndOfStream: false) < HeadLength || head.EndsWith("IEND"u8))
        {
            _isAtEnd = true;
            return;
        }

        long length = BinaryPrimitives.ReadUInt32BigEndian(head);
        if (length + ChecksumLength > file.Length - file.Position)
        {
            throw new DatasetFormatException(
                FormattableString.Invariant($"its pixels are damaged: a chunk of {length} bytes is longer than the file.")
            );
        }

        if (head.EndsWith("IDAT"u8) && length > 0)
        {
            _left = length;
        }
        else
        {
            file.Seek(length + ChecksumLength, SeekOrigin.Current);
        }
    }
}
