using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;
using Microsoft.Win32.SafeHandles;

namespace Harvester.Reports.Viewing;

/// <summary>
/// Where the lines of a text file begin, so that any line can be read without those before it. The file may grow; a last line without
/// line feed is not part of it yet. Several threads may read lines while one extends the index.
/// </summary>
internal sealed class LineIndex : IDisposable
{
    /// <summary>Lines that are found at most; the index takes 8 bytes for each.</summary>
    public const int MaxLines = 1 << 22;

    private const int BufferBytes = 1 << 20;

    private readonly string _path;
    private readonly List<long> _starts = [0];
    private readonly byte[] _buffer = new byte[BufferBytes];
    private FileStream? _stream;
    private long _scanned;

    /// <summary>Creates an empty index of a file, which need not exist yet.</summary>
    public LineIndex(string path)
    {
        _path = path;
    }

    /// <summary>Number of lines found so far.</summary>
    public int Count
    {
        get
        {
            lock (_starts)
            {
                return _starts.Count - 1;
            }
        }
    }

    /// <summary>Whether there are <see cref="MaxLines"/> lines; no further ones are looked for.</summary>
    public bool IsFull => Count == MaxLines;

    /// <summary>Looks for further lines.</summary>
    /// <param name="maxBytes">Bytes to read at most.</param>
    /// <returns>Whether there may be more of them.</returns>
    /// <exception cref="IOException">The file cannot be read, or has become shorter.</exception>
    public bool Extend(long maxBytes)
    {
        if (_stream is null && !File.Exists(_path))
        {
            return false;
        }

        // Another process may append to the file, or replace it; a replaced file is still read as it was.
        _stream ??= RegularFile.OpenRead(_path, FileShare.ReadWrite | FileShare.Delete);
        SafeFileHandle file = _stream.SafeFileHandle;
        if (RandomAccess.GetLength(file) < _scanned)
        {
            throw new IOException($"'{_path}' has become shorter. Start the viewer again.");
        }

        for (long end = _scanned + maxBytes; _scanned < end; )
        {
            if (IsFull)
            {
                return false;
            }

            int length = RandomAccess.Read(file, _buffer, _scanned);
            if (length == 0)
            {
                return false;
            }

            Add(_buffer.AsSpan(0, length));
            _scanned += length;
        }

        return true;
    }

    /// <summary>The bytes of a line, without its line feed.</summary>
    /// <param name="index">Number of the line, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such line.</exception>
    /// <exception cref="DatasetFormatException">The line is too long.</exception>
    /// <exception cref="IOException">The file cannot be read, or has become shorter.</exception>
    public byte[] Read(int index)
    {
        (long start, long length) = PlaceOf(index);
        if (length > InputFile.MaxLineCharacters)
        {
            throw new DatasetFormatException($"'{_path}', line {index + 1} is longer than {InputFile.MaxLineCharacters} bytes, the limit.");
        }

        byte[] line = new byte[length];
        for (int at = 0, read; at < line.Length; at += read)
        {
            read = RandomAccess.Read(_stream!.SafeFileHandle, line.AsSpan(at), start + at);
            if (read == 0)
            {
                throw new IOException($"'{_path}' has become shorter. Start the viewer again.");
            }
        }

        return line;
    }

    /// <inheritdoc/>
    public void Dispose() => _stream?.Dispose();

    private (long Start, long Length) PlaceOf(int index)
    {
        lock (_starts)
        {
            ArgumentOutOfRangeException.ThrowIfNegative(index);
            ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(index, _starts.Count - 1);
            return (_starts[index], _starts[index + 1] - _starts[index] - 1);
        }
    }

    private void Add(ReadOnlySpan<byte> bytes)
    {
        lock (_starts)
        {
            int at = 0;
            for (int found; _starts.Count <= MaxLines && (found = bytes[at..].IndexOf((byte)'\n')) >= 0; at += found + 1)
            {
                _starts.Add(_scanned + at + found + 1);
            }
        }
    }
}
