using System.Globalization;
using System.Text;
using Harvester.Geometry;

namespace Harvester.Sessions.Text;

/// <summary>
/// Writes JSON (RFC 8259) in the order of the calls; JSON libraries are not available in the game. On one line, or with the members of
/// objects on lines of their own.
/// </summary>
internal sealed class JsonText(bool indented = false)
{
    private readonly StringBuilder _text = new();
    private int _depth;
    private bool _needsComma;
    private bool _afterKey;

    public JsonText BeginObject() => Begin('{');

    public JsonText EndObject()
    {
        _depth--;
        if (_needsComma)
        {
            NewLine();
        }

        return Close('}');
    }

    public JsonText BeginArray() => Begin('[');

    public JsonText EndArray()
    {
        _depth--;
        return Close(']');
    }

    public JsonText Key(string name)
    {
        if (_needsComma)
        {
            _text.Append(',');
        }

        NewLine();
        _needsComma = false;
        Quote(name);
        _text.Append(indented ? ": " : ":");
        _afterKey = true;
        return this;
    }

    public JsonText Number(double value, int decimals)
    {
        Separate();
        InvariantNumber.Append(_text, value, decimals);
        return this;
    }

    public JsonText Number(double? value, int decimals) => value is { } known ? Number(known, decimals) : Word("null");

    /// <summary>A number that reads back as the same double; it may have an exponent.</summary>
    public JsonText Exact(double value)
    {
        // Negative zero is written as zero.
        double number = value + 0.0;
#if NET
        return Word(number.ToString("R", CultureInfo.InvariantCulture));
#else
        // .NET Framework's shortest form does not always read back; seventeen digits do.
        string shortest = number.ToString("R", CultureInfo.InvariantCulture);
        return Word(
            double.Parse(shortest, CultureInfo.InvariantCulture).Equals(number)
                ? shortest
                : number.ToString("G17", CultureInfo.InvariantCulture)
        );
#endif
    }

    public JsonText Exact(double? value) => value is { } known ? Exact(known) : Word("null");

    public JsonText Exact(Vector3D value) => BeginArray().Exact(value.X).Exact(value.Y).Exact(value.Z).EndArray();

    public JsonText Integer(long value)
    {
        Separate();
        _text.Append(value.ToString(CultureInfo.InvariantCulture));
        return this;
    }

    public JsonText Integer(long? value) => value is { } known ? Integer(known) : Word("null");

    public JsonText Boolean(bool value) => Word(value ? "true" : "false");

    public JsonText Boolean(bool? value) => value is { } known ? Boolean(known) : Word("null");

    public JsonText Null() => Word("null");

    public JsonText String(string? value)
    {
        if (value is null)
        {
            return Word("null");
        }

        Separate();
        Quote(value);
        return this;
    }

    public JsonText Vector(Vector3D value, int decimals) =>
        BeginArray().Number(value.X, decimals).Number(value.Y, decimals).Number(value.Z, decimals).EndArray();

    public JsonText Box(Box2D? value, int decimals) =>
        value is { } box
            ? BeginArray()
                .Number(box.XMin, decimals)
                .Number(box.YMin, decimals)
                .Number(box.XMax, decimals)
                .Number(box.YMax, decimals)
                .EndArray()
            : Word("null");

    public override string ToString() => _text.ToString();

    private JsonText Word(string word)
    {
        Separate();
        _text.Append(word);
        return this;
    }

    private JsonText Begin(char bracket)
    {
        Separate();
        _text.Append(bracket);
        _depth++;
        _needsComma = false;
        return this;
    }

    private JsonText Close(char bracket)
    {
        _text.Append(bracket);
        _needsComma = true;
        return this;
    }

    /// <summary>Writes what precedes a value: nothing after a key, a comma after another element.</summary>
    private void Separate()
    {
        if (_needsComma && !_afterKey)
        {
            _text.Append(indented ? ", " : ",");
        }

        _afterKey = false;
        _needsComma = true;
    }

    private void NewLine()
    {
        if (indented)
        {
            _text.Append('\n').Append(' ', 2 * _depth);
        }
    }

    private void Quote(string value)
    {
        _text.Append('"');
        foreach (char c in value)
        {
            if (c is '"' or '\\')
            {
                _text.Append('\\').Append(c);
            }
            else if (c < ' ' || char.IsSurrogate(c))
            {
                // Surrogates are escaped one by one, so that a lone one does not make the file's UTF-8 invalid.
                _text.Append("\\u").Append(((int)c).ToString("x4", CultureInfo.InvariantCulture));
            }
            else
            {
                _text.Append(c);
            }
        }

        _text.Append('"');
    }
}
