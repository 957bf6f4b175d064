using System.Globalization;
using System.Text;

namespace Harvester.Sessions.Text;

/// <summary>
/// Reads a JSON text (RFC 8259) from front to back, one value per call: the JSON reader of the code that runs in the game, where
/// System.Text.Json is not available. Every method throws <see cref="FormatException"/> if the text has something else at that point.
/// </summary>
/// <param name="text">The text.</param>
internal sealed class JsonReader(string text)
{
    /// <summary>Objects and lists within each other, as System.Text.Json allows them; text from outside cannot exhaust the stack.</summary>
    public const int MaxDepth = 64;

    private int _at;
    private int _depth;

    /// <summary>The first character of what comes next, after white space; '\0' at the end of the text.</summary>
    public char Next
    {
        get
        {
            while (_at < text.Length && text[_at] is ' ' or '\t' or '\r' or '\n')
            {
                _at++;
            }

            return _at < text.Length ? text[_at] : '\0';
        }
    }

    /// <summary>Reads an object. The callback gets the name of each field and must read its value.</summary>
    public void Object(Action<string> readField) =>
        Items(
            '{',
            '}',
            () =>
            {
                string name = String();
                Expect(':');
                readField(name);
            }
        );

    /// <summary>Reads a list. The callback must read one item.</summary>
    public void List(Action readItem) => Items('[', ']', readItem);

    /// <summary>Reads a string.</summary>
    public string String()
    {
        Expect('"');
        var value = new StringBuilder();
        while (_at < text.Length && text[_at] != '"')
        {
            char letter = text[_at++];
            value.Append(
                letter == '\\' ? Escape()
                : letter >= ' ' ? letter
                : throw Wrong("a control character in a string")
            );
        }

        if (_at >= text.Length)
        {
            throw Wrong("the end of the text in a string");
        }

        _at++;
        return value.ToString();
    }

    /// <summary>Reads a finite number.</summary>
    public double Number()
    {
        char first = Next;
        int start = _at;
        while (_at < text.Length && (char.IsDigit(text[_at]) || text[_at] is '-' or '+' or '.' or 'e' or 'E'))
        {
            _at++;
        }

        bool isNumber = double.TryParse(
            text.Substring(start, _at - start),
            NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent,
            CultureInfo.InvariantCulture,
            out double number
        );
        return isNumber && !double.IsInfinity(number) && !double.IsNaN(number)
            ? number
            : throw Wrong(first == '\0' ? "the end of the text instead of a value" : "an invalid number");
    }

    /// <summary>Reads true or false.</summary>
    public bool Boolean()
    {
        bool value = Next == 't';
        Word(value ? "true" : "false");
        return value;
    }

    /// <summary>Reads null.</summary>
    public void Null() => Word("null");

    /// <summary>Reads a value of any kind and discards it.</summary>
    public void Skip()
    {
        switch (Next)
        {
            case '{':
                Object(_ => Skip());
                break;
            case '[':
                List(Skip);
                break;
            case '"':
                String();
                break;
            case 't' or 'f':
                Boolean();
                break;
            case 'n':
                Null();
                break;
            default:
                Number();
                break;
        }
    }

    /// <summary>Requires that only white space is left.</summary>
    public void End()
    {
        if (Next != '\0')
        {
            throw Wrong("more text after the value");
        }
    }

    /// <summary>The error that something unexpected stands at the current position.</summary>
    /// <param name="found">What is wrong.</param>
    public FormatException Wrong(string found)
    {
        int lines = 1;
        int start = 0;
        for (int i = 0; i < _at; i++)
        {
            if (text[i] == '\n')
            {
                lines++;
                start = i + 1;
            }
        }

        int bytes = Encoding.UTF8.GetByteCount(text.Substring(start, _at - start));
        return new(FormattableString.Invariant($"invalid JSON at line {lines}, byte {bytes + 1}: {found}"));
    }

    private void Items(char begin, char end, Action readItem)
    {
        Expect(begin);
        if (++_depth > MaxDepth)
        {
            throw Wrong(FormattableString.Invariant($"more than {MaxDepth} nested values"));
        }

        if (Next != end)
        {
            do
            {
                readItem();
            } while (Take(','));
        }

        Expect(end);
        _depth--;
    }

    private void Word(string word)
    {
        _ = Next;
        if (string.CompareOrdinal(text, _at, word, 0, word.Length) != 0)
        {
            throw Wrong("an unknown word");
        }

        _at += word.Length;
    }

    private char Escape()
    {
        char letter = _at < text.Length ? text[_at++] : '\0';
        switch (letter)
        {
            case '"' or '\\' or '/':
                return letter;
            case 'b':
                return '\b';
            case 'f':
                return '\f';
            case 'n':
                return '\n';
            case 'r':
                return '\r';
            case 't':
                return '\t';
            case 'u'
                when _at + 4 <= text.Length
                    && ushort.TryParse(
                        text.Substring(_at, 4),
                        NumberStyles.AllowHexSpecifier,
                        CultureInfo.InvariantCulture,
                        out ushort code
                    ):
                _at += 4;
                return (char)code;
            default:
                throw Wrong("an unknown escape in a string");
        }
    }

    private bool Take(char letter)
    {
        if (Next != letter)
        {
            return false;
        }

        _at++;
        return true;
    }

    private void Expect(char letter)
    {
        if (!Take(letter))
        {
            throw Wrong($"expected {letter}");
        }
    }
}
