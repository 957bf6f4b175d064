using System.Text;

namespace Harvester.Sessions.Reading.Files;

/// <summary>A text that is read by lines. A line that is too long is rejected before it is in memory.</summary>
/// <param name="text">The text.</param>
/// <param name="name">Name in messages.</param>
/// <param name="maxLineCharacters">Longest line, characters.</param>
internal sealed class LimitedTextReader(TextReader text, string name, int maxLineCharacters = InputFile.MaxLineCharacters) : TextReader
{
    private const int BufferLength = 1 << 14;

    private readonly char[] _buffer = new char[BufferLength];
    private int _start;
    private int _end;
    private int _line;
    private int _lineLength;

    public override string? ReadLine()
    {
        StringBuilder? begun = null;
        while (Fill())
        {
            ReadOnlySpan<char> rest = _buffer.AsSpan(_start, _end - _start);
            int length = rest.IndexOfAny('\r', '\n');
            if (length >= 0)
            {
                string line = Joined(begun, rest[..length])!;
                _start += length;
                TakeLineEnd();
                _line++;
                return line;
            }

            begun = (begun ?? new StringBuilder()).Append(rest);
            _start = _end;
            RequireShort(begun.Length);
        }

        return begun?.ToString();
    }

    public override int Peek() => Fill() ? _buffer[_start] : -1;

    public override int Read() => Fill() ? _buffer[_start++] : -1;

    public override int Read(char[] buffer, int index, int count)
    {
        if (!Fill())
        {
            return 0;
        }

        int taken = Math.Min(count, _end - _start);
        Array.Copy(_buffer, _start, buffer, index, taken);
        _start += taken;
        CountLines(buffer.AsSpan(index, taken));
        return taken;
    }

    protected override void Dispose(bool disposing)
    {
        if (disposing)
        {
            text.Dispose();
        }

        base.Dispose(disposing);
    }

    private void CountLines(ReadOnlySpan<char> passed)
    {
        int lineFeeds = passed.Count('\n');
        _line += lineFeeds;
        _lineLength = lineFeeds > 0 ? passed.Length - passed.LastIndexOf('\n') : _lineLength + passed.Length;
        RequireShort(_lineLength);
    }

    private string? Joined(StringBuilder? begun, ReadOnlySpan<char> rest)
    {
        RequireShort((begun?.Length ?? 0) + rest.Length);
        return begun is null ? rest.ToString() : begun.Append(rest).ToString();
    }

    private void RequireShort(int length)
    {
        if (length > maxLineCharacters)
        {
            throw new DatasetFormatException(
                FormattableString.Invariant($"{name}, line {_line + 1}: the line has more than {maxLineCharacters} characters, the limit.")
            );
        }
    }

    private void TakeLineEnd()
    {
        bool isReturn = _buffer[_start++] == '\r';
        if (isReturn && Fill() && _buffer[_start] == '\n')
        {
            _start++;
        }
    }

    private bool Fill()
    {
        if (_start == _end)
        {
            _start = 0;
            _end = text.Read(_buffer, 0, _buffer.Length);
        }

        return _end > 0;
    }
}
