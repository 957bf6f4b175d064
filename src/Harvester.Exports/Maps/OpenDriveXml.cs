using System.Globalization;
using System.Text;
using System.Xml;

namespace Harvester.Exports.Maps;

/// <summary>Writes the elements of an OpenDRIVE file.</summary>
internal sealed class OpenDriveXml(Stream stream) : IDisposable
{
    private const int Decimals = 10;

    private readonly XmlWriter _xml = XmlWriter.Create(
        stream,
        new XmlWriterSettings
        {
            Indent = true,
            NewLineChars = "\n",
            Encoding = new UTF8Encoding(false),
            CloseOutput = false,
        }
    );

    public static string Text(int value) => value.ToString(CultureInfo.InvariantCulture);

    // Adding 0 turns -0 into 0.
    public static string Text(double value) => (Math.Round(value, Decimals) + 0.0).ToString("0.##########", CultureInfo.InvariantCulture);

    public void Begin(string name, params ReadOnlySpan<(string Name, string Value)> attributes)
    {
        _xml.WriteStartElement(name);
        foreach ((string attribute, string value) in attributes)
        {
            _xml.WriteAttributeString(attribute, Valid(value));
        }
    }

    public void End() => _xml.WriteEndElement();

    public void Element(string name, params ReadOnlySpan<(string Name, string Value)> attributes)
    {
        Begin(name, attributes);
        End();
    }

    /// <summary>A polynomial a + b ds from a station on.</summary>
    public void Polynomial(string name, double station, double a, double b, string attribute = "s") =>
        Element(name, (attribute, Text(station)), ("a", Text(a)), ("b", Text(b)), ("c", "0"), ("d", "0"));

    /// <summary>The text with a replacement character for each that XML does not allow.</summary>
    private static string Valid(string text) =>
        string.Concat(
            text.EnumerateRunes().Select(rune => rune.IsBmp && !XmlConvert.IsXmlChar((char)rune.Value) ? Rune.ReplacementChar : rune)
        );

    public void Dispose() => _xml.Dispose();
}
