using System.Collections.Frozen;
using System.Text;
using System.Text.Json;
using System.Xml;
using Harvester.Geometry;
using Harvester.Sessions.Text;

namespace Harvester.Pages;

/// <summary>
/// Writes HTML and SVG elements to a stream. Text and attribute values are escaped here and nowhere else; element and attribute names are
/// constants of the caller. Only the names of open elements are held in memory.
/// </summary>
public sealed class MarkupWriter : IDisposable
{
    private const int PixelDecimals = 1;

    /// <summary>HTML elements without end tag. SVG elements may always be self-closing.</summary>
    private static readonly FrozenSet<string> VoidElements = FrozenSet.Create(
        StringComparer.Ordinal,
        "br",
        "hr",
        "img",
        "input",
        "link",
        "meta"
    );

    private static readonly XmlWriterSettings Settings = new()
    {
        CloseOutput = false,
        Encoding = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false),
        NewLineHandling = NewLineHandling.None,
        OmitXmlDeclaration = true,
    };

    private readonly Stream _stream;
    private readonly XmlWriter _xml;
    private readonly string _namespace;
    private readonly Stack<string> _open = new();
    private int _svgDepth;

    /// <summary>Starts writing.</summary>
    /// <param name="stream">Receives UTF-8 without a byte order mark; stays open.</param>
    /// <param name="xmlNamespace">Namespace of all elements; empty for HTML, whose parser knows SVG.</param>
    internal MarkupWriter(Stream stream, string xmlNamespace)
    {
        _stream = stream;
        _namespace = xmlNamespace;
        _xml = XmlWriter.Create(stream, Settings);
    }

    /// <summary>Opens an element.</summary>
    public MarkupWriter Start(string element)
    {
        _xml.WriteStartElement(null, element, _namespace);
        _open.Push(element);
        _svgDepth += IsSvgRoot(element) ? 1 : 0;
        return this;
    }

    /// <summary>Closes the innermost open element.</summary>
    public MarkupWriter End()
    {
        string element = _open.Pop();
        if (_svgDepth > 0 || VoidElements.Contains(element))
        {
            _xml.WriteEndElement();
        }
        else
        {
            // HTML takes <td /> for a start tag.
            _xml.WriteFullEndElement();
        }

        _svgDepth -= IsSvgRoot(element) ? 1 : 0;
        return this;
    }

    /// <summary>Writes an element that contains only text.</summary>
    public MarkupWriter Element(string element, string text) => Start(element).Text(text).End();

    /// <summary>Adds an attribute to the element just opened.</summary>
    public MarkupWriter With(string attribute, string value)
    {
        _xml.WriteAttributeString(attribute, Valid(value));
        return this;
    }

    /// <summary>Adds a number as an attribute, by default rounded to tenths.</summary>
    public MarkupWriter With(string attribute, double value, int decimals = PixelDecimals) =>
        With(attribute, InvariantNumber.Format(value, decimals));

    /// <summary>Adds the attribute "points": the corners of a polygon or polyline, pixels.</summary>
    public MarkupWriter WithPoints(IEnumerable<Vector2D> points)
    {
        ArgumentNullException.ThrowIfNull(points);
        _xml.WriteStartAttribute("points");
        string separator = "";
        foreach (Vector2D point in points)
        {
            _xml.WriteString(separator + Pixels(point, ','));
            separator = " ";
        }

        _xml.WriteEndAttribute();
        return this;
    }

    /// <summary>Adds the attribute "d" of a path that consists of open lines, pixels.</summary>
    public MarkupWriter WithLines(IEnumerable<IEnumerable<Vector2D>> lines)
    {
        ArgumentNullException.ThrowIfNull(lines);
        _xml.WriteStartAttribute("d");
        foreach (IEnumerable<Vector2D> line in lines)
        {
            string command = "M";
            foreach (Vector2D point in line)
            {
                _xml.WriteString(command + Pixels(point, ' '));
                command = "L";
            }
        }

        _xml.WriteEndAttribute();
        return this;
    }

    /// <summary>Adds the content of a file as a data URL, so that the page needs no other file.</summary>
    /// <param name="attribute">The attribute, usually "src" or "href".</param>
    /// <param name="mediaType">The media type, such as image/png.</param>
    /// <param name="content">The content of the file.</param>
    public MarkupWriter WithData(string attribute, string mediaType, byte[] content)
    {
        ArgumentNullException.ThrowIfNull(content);
        _xml.WriteStartAttribute(attribute);
        _xml.WriteString($"data:{Valid(mediaType)};base64,");
        _xml.WriteBase64(content, 0, content.Length);
        _xml.WriteEndAttribute();
        return this;
    }

    /// <summary>Writes text into the open element.</summary>
    public MarkupWriter Text(string text)
    {
        _xml.WriteString(Valid(text));
        return this;
    }

    /// <summary>Writes bytes as base64 text into the open element.</summary>
    public MarkupWriter Base64(byte[] content)
    {
        ArgumentNullException.ThrowIfNull(content);
        _xml.WriteBase64(content, 0, content.Length);
        return this;
    }

    /// <summary>Writes a line end, which does not change what is shown.</summary>
    public MarkupWriter NewLine()
    {
        _xml.WriteWhitespace("\n");
        return this;
    }

    /// <summary>Writes markup unescaped; it must be the program's own.</summary>
    public MarkupWriter Markup(string markup)
    {
        _xml.WriteRaw(markup);
        return this;
    }

    /// <summary>Writes the program's own style sheet or script.</summary>
    /// <param name="element">"style" or "script".</param>
    /// <param name="code">The code; it cannot contain the element's end tag, which HTML would not unescape.</param>
    /// <exception cref="ArgumentException">The code contains the end tag.</exception>
    public MarkupWriter Code(string element, string code)
    {
        ArgumentNullException.ThrowIfNull(code);
        return code.Contains("</" + element, StringComparison.OrdinalIgnoreCase)
            ? throw new ArgumentException($"The code contains the end tag of '{element}'.", nameof(code))
            : Start(element).Markup("\n" + code).End().NewLine();
    }

    /// <summary>Writes data for a script of the page, as a script element that holds JSON.</summary>
    /// <param name="id">The element's id.</param>
    /// <param name="write">Writes one JSON value.</param>
    public MarkupWriter Json(string id, Action<Utf8JsonWriter> write)
    {
        ArgumentNullException.ThrowIfNull(write);
        Start("script").With("type", "application/json").With("id", id).NewLine();
        _xml.Flush();

        // The default encoder escapes '<' and '&', so no name can end the script element.
        using (var json = new Utf8JsonWriter(_stream))
        {
            write(json);
        }

        return End().NewLine();
    }

    /// <summary>Writes what is still buffered; the stream stays open.</summary>
    public void Dispose() => _xml.Dispose();

    private static bool IsSvgRoot(string element) => element == "svg";

    private static string Pixels(Vector2D point, char separator)
    {
        var text = new StringBuilder();
        InvariantNumber.Append(text, point.X, PixelDecimals);
        text.Append(separator);
        InvariantNumber.Append(text, point.Y, PixelDecimals);
        return text.ToString();
    }

    /// <summary>Replaces characters that XML and HTML do not allow even if escaped: control characters and unpaired surrogates.</summary>
    private static string Valid(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        if (!text.AsSpan().ContainsAnyExceptInRange(' ', '~'))
        {
            return text;
        }

        var valid = new StringBuilder(text.Length);
        foreach (Rune rune in text.EnumerateRunes())
        {
            valid.Append(rune.IsBmp && !XmlConvert.IsXmlChar((char)rune.Value) ? Rune.ReplacementChar : rune);
        }

        return valid.ToString();
    }
}
