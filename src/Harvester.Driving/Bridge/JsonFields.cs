using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace Harvester.Driving.Bridge;

/// <summary>
/// Reads one flat JSON object (RFC 8259) whose values are strings, numbers, true, false, null or arrays of numbers: what clients send.
/// The library that would do it is not to be had in the game. Anything else is refused.
/// </summary>
internal sealed class JsonFields
{
    private readonly Dictionary<string, object?> _values = new(StringComparer.Ordinal);
    private readonly string _text;
    private int _at;

    private JsonFields(string text) => _text = text;

    /// <exception cref="BridgeException">The text is not such an object.</exception>
    public static JsonFields Parse(string text)
    {
        var fields = new JsonFields(text);
        fields.ReadObject();
        return fields;
    }

    public bool Has(string name) => _values.TryGetValue(name, out object? value) && value is not null;

    public string Text(string name) =>
        _values.TryGetValue(name, out object? value) && value is string text ? text
            : throw new BridgeException($"field {name} must be a string.");

    public double Number(string name) =>
        _values.TryGetValue(name, out object? value) && value is double number ? number
            : throw new BridgeException($"field {name} must be a number.");

    public bool Boolean(string name) =>
        _values.TryGetValue(name, out object? value) && value is bool truth ? truth
            : throw new BridgeException($"field {name} must be true or false.");

    public double[] Numbers(string name, int count) =>
        _values.TryGetValue(name, out object? value) && value is double[] numbers && numbers.Length == count
            ? numbers
            : throw new BridgeException(FormattableString.Invariant($"field {name} must be an array of {count} numbers."));

    private void ReadObject()
    {
        Expect('{');
        if (Peek() != '}')
        {
            do
            {
                string name = ReadString();
                Expect(':');
                if (_values.ContainsKey(name))
                {
                    throw Wrong($"the field {ClientText.Quoted(name)} again");
                }

                _values.Add(name, ReadValue());
            }
            while (Take(','));
        }

        Expect('}');
        if (Peek() != '\0')
        {
            throw Wrong("something after the object");
        }
    }

    private object? ReadValue() => Peek() switch
    {
        '"' => ReadString(),
        '[' => ReadNumbers(),
        't' => ReadWord("true", true),
        'f' => ReadWord("false", false),
        'n' => ReadWord("null", null),
        _ => ReadNumber(),
    };

    private double[] ReadNumbers()
    {
        Expect('[');
        var numbers = new List<double>();
        if (Peek() != ']')
        {
            do
            {
                Peek();
                numbers.Add(ReadNumber());
            }
            while (Take(','));
        }

        Expect(']');
        return [.. numbers];
    }

    private object? ReadWord(string word, object? value)
    {
        if (string.CompareOrdinal(_text, _at, word, 0, word.Length) != 0)
        {
            throw Wrong("an unknown word");
        }

        _at += word.Length;
        return value;
    }

    private double ReadNumber()
    {
        int start = _at;
        while (_at < _text.Length && (char.IsDigit(_text[_at]) || _text[_at] is '-' or '+' or '.' or 'e' or 'E'))
        {
            _at++;
        }

        string digits = _text.Substring(start, _at - start);
        bool isNumber = double.TryParse(
            digits, NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent,
                CultureInfo.InvariantCulture, out double number);
        return isNumber && !double.IsInfinity(number) && !double.IsNaN(number) ? number : throw Wrong("what is no number");
    }

    private string ReadString()
    {
        Expect('"');
        var text = new StringBuilder();
        while (_at < _text.Length && _text[_at] != '"')
        {
            char letter = _text[_at++];
            text.Append(letter == '\\' ? ReadEscape() : letter >= ' ' ? letter : throw Wrong("a control character in a string"));
        }

        if (_at >= _text.Length)
        {
            throw Wrong("the end within a string");
        }

        _at++;
        return text.ToString();
    }

    private char ReadEscape()
    {
        char letter = _at < _text.Length ? _text[_at++] : '\0';
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
            case 'u' when _at + 4 <= _text.Length
                && ushort.TryParse(_text.Substring(_at, 4), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out ushort code):
                _at += 4;
                return (char)code;
            default:
                throw Wrong("an unknown escape in a string");
        }
    }

    private char Peek()
    {
        while (_at < _text.Length && _text[_at] is ' ' or '\t' or '\r' or '\n')
        {
            _at++;
        }

        return _at < _text.Length ? _text[_at] : '\0';
    }

    private bool Take(char letter)
    {
        if (Peek() != letter)
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
            throw Wrong($"something else where {letter} belongs");
        }
    }

    private BridgeException Wrong(string found) =>
        new(FormattableString.Invariant($"the header is not a flat JSON object: {found} at character {_at + 1}."));
}
