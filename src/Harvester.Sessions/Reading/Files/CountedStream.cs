namespace Harvester.Sessions.Reading.Files;

/// <summary>A stream that reports its total number of bytes after each read, to detect decompression bombs.</summary>
/// <param name="inner">The stream.</param>
/// <param name="passed">Receives the number of bytes so far.</param>
/// <param name="limit">Checks the bytes; null for no check.</param>
internal sealed class CountedStream(Stream inner, Action<long> passed, IByteLimit? limit = null) : Stream
{
    private long _position;

    public override bool CanRead => true;

    public override bool CanSeek => false;

    public override bool CanWrite => false;

    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => _position;
        set => throw new NotSupportedException();
    }

    public override int Read(byte[] buffer, int offset, int count) => Read(buffer.AsSpan(offset, count));

    public override int Read(Span<byte> buffer)
    {
        int read = Counted(inner.Read(buffer));
        limit?.Pass(buffer[..read]);
        return read;
    }

    // The source is a file: reading it synchronously costs less than switching threads.
    public override ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellationToken = default) =>
        ValueTask.FromResult(Read(buffer.Span));

    public override void Flush() { }

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    protected override void Dispose(bool disposing)
    {
        if (disposing)
        {
            inner.Dispose();
        }

        base.Dispose(disposing);
    }

    private int Counted(int read)
    {
        _position += read;
        passed(_position);
        return read;
    }
}
