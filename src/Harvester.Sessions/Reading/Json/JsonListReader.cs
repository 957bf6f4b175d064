using System.Text.Json;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading.Json;

/// <summary>
/// Reads a file with a JSON object whose fields are lists, or with one list, element by element, so that the file may have any length.
/// Other fields are skipped.
/// </summary>
internal sealed class JsonListReader : IDisposable
{
    private const int FirstBufferBytes = 1 << 16;
    private readonly int _elementDepth;

    private readonly FileStream _file;
    private byte[] _buffer = new byte[FirstBufferBytes];
    private int _start;
    private int _end;
    private bool _isAtEnd;
    private bool _isInList;
    private int _line = 1;
    private JsonReaderState _state;

    /// <summary>Opens a file.</summary>
    /// <param name="path">The file.</param>
    /// <param name="isBare">Whether the whole file is one list, instead of an object with lists.</param>
    public JsonListReader(string path, bool isBare = false)
    {
        _elementDepth = isBare ? 1 : 2;
        _file = InputFile.OpenRead(path);
    }

    /// <summary>Whether the file has begun a list, or an object with one, so that elements may follow.</summary>
    public bool HasList { get; private set; }

    /// <summary>Bytes of the file that have been read.</summary>
    public long Position => _file.Position;

    /// <summary>Length of the file, bytes.</summary>
    public long Length => _file.Length;

    /// <summary>Name of the list of the current element.</summary>
    public string List { get; private set; } = "";

    /// <summary>Line of the file on which the element begins, from 1.</summary>
    public int Line { get; private set; }

    /// <summary>The element read last.</summary>
    public JsonElement Element { get; private set; }

    /// <summary>Advances to the next element; returns false at the end.</summary>
    /// <exception cref="JsonException">The file is not valid JSON.</exception>
    /// <exception cref="DatasetFormatException">A name or string is not valid Unicode, or an element is too large.</exception>
    public bool Read()
    {
        while (true)
        {
            if (TryReadFromBuffer())
            {
                return true;
            }

            if (_isAtEnd)
            {
                return false;
            }

            Fill();
        }
    }

    public void Dispose() => _file.Dispose();

    private bool TryReadFromBuffer()
    {
        var reader = new Utf8JsonReader(_buffer.AsSpan(_start, _end - _start), _isAtEnd, _state);
        while (true)
        {
            Utf8JsonReader before = reader;
            if (!reader.Read())
            {
                Advance(reader);
                return false;
            }

            bool isElement = _isInList && reader.CurrentDepth == _elementDepth;
            if (isElement && !reader.TrySkip())
            {
                Advance(before);
                return false;
            }

            if (isElement)
            {
                int begin = (int)before.BytesConsumed;
                ReadOnlyMemory<byte> text = _buffer.AsMemory(_start + begin, (int)reader.BytesConsumed - begin);
                Line = _line + text.Span[..LeadingBytes(text.Span)].Count((byte)'\n') + _buffer.AsSpan(_start, begin).Count((byte)'\n');
                using JsonDocument document = JsonInput.Parse(text[LeadingBytes(text.Span)..]);
                Element = document.RootElement.Clone();
                Advance(reader);
                return true;
            }

            if (reader.CurrentDepth == _elementDepth - 1)
            {
                List = reader.TokenType == JsonTokenType.PropertyName ? NameOf(reader) : List;
                _isInList = reader.TokenType == JsonTokenType.StartArray;
                HasList |= _isInList;
            }
        }
    }

    private static string NameOf(in Utf8JsonReader reader)
    {
        try
        {
            return reader.GetString()!;
        }
        catch (InvalidOperationException e)
        {
            throw new DatasetFormatException("a name in it is not valid Unicode.", e);
        }
    }

    /// <summary>Skips blanks and a comma between the previous token and the element.</summary>
    private static int LeadingBytes(ReadOnlySpan<byte> text) => text.IndexOfAnyExcept(" \t\r\n,"u8);

    private void Advance(in Utf8JsonReader reader)
    {
        int consumed = (int)reader.BytesConsumed;
        _line += _buffer.AsSpan(_start, consumed).Count((byte)'\n');
        _start += consumed;
        _state = reader.CurrentState;
    }

    /// <summary>Skips the mark that editors on Windows put before a text in UTF-8.</summary>
    private void SkipByteOrderMark()
    {
        Span<byte> start = stackalloc byte[3];
        int length = _file.ReadAtLeast(start, start.Length, throwOnEndOfStream: false);
        _file.Position = start[..length].SequenceEqual("\uFEFF"u8) ? length : 0;
    }

    private void Fill()
    {
        _buffer.AsSpan(_start, _end - _start).CopyTo(_buffer);
        _end -= _start;
        _start = 0;
        if (_end == _buffer.Length)
        {
            if (_buffer.Length >= InputFile.MaxDocumentBytes)
            {
                throw new DatasetFormatException(
                    FormattableString.Invariant($"an element or a text of it has more than {InputFile.MaxDocumentBytes} bytes, the limit.")
                );
            }

            Array.Resize(ref _buffer, _buffer.Length * 2);
        }

        if (_file.Position == 0)
        {
            SkipByteOrderMark();
        }

        int read = _file.Read(_buffer, _end, _buffer.Length - _end);
        _end += read;
        _isAtEnd = read == 0;
    }
}
