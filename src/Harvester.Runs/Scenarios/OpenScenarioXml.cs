using System.Globalization;
using System.Xml;
using System.Xml.Linq;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Runs.Scenarios;

/// <summary>Reads elements of OpenSCENARIO files of any origin.</summary>
internal static class OpenScenarioXml
{
    /// <summary>Elements are nested at most so deeply; those of OpenSCENARIO reach 20.</summary>
    private const int MaxDepth = 64;

    /// <summary>Parses a text.</summary>
    /// <exception cref="DatasetFormatException">It is not XML, too long or nested too deeply.</exception>
    public static XElement Load(string text, int maxCharacters)
    {
        var settings = new XmlReaderSettings
        {
            DtdProcessing = DtdProcessing.Prohibit,
            XmlResolver = null,
            MaxCharactersInDocument = maxCharacters,
            IgnoreComments = true,
            IgnoreWhitespace = true,
            IgnoreProcessingInstructions = true,
        };
        try
        {
            // A document that is nested too deeply must not reach the tree, whose disposal and errors take time with the depth.
            using (var shallow = XmlReader.Create(new StringReader(text), settings))
            {
                while (shallow.Read())
                {
                    if (shallow.Depth > MaxDepth)
                    {
                        throw new DatasetFormatException(
                            $"line {((IXmlLineInfo)shallow).LineNumber}: elements are nested more than {MaxDepth} levels deep."
                        );
                    }
                }
            }

            using var reader = XmlReader.Create(new StringReader(text), settings);
            return XElement.Load(reader, LoadOptions.SetLineInfo);
        }
        catch (XmlException e)
        {
            string what = e.Message.Contains("DTD", StringComparison.Ordinal) ? "document types (DTDs) are not allowed." : e.Message;
            throw new DatasetFormatException(e.LineNumber > 0 ? $"line {e.LineNumber}: {what}" : what, e);
        }
    }

    /// <summary>The child of a name.</summary>
    public static XElement The(this XElement element, string name) =>
        element.Element(name) ?? throw Wrong(element, $"{element.Name.LocalName} must have {name}.");

    /// <summary>The only child.</summary>
    public static XElement Only(this XElement element) =>
        element.Elements().ToArray() is [var one] ? one : throw Wrong(element, $"{element.Name.LocalName} must have one element.");

    /// <summary>An attribute.</summary>
    public static string Text(this XElement element, string name) =>
        element.Attribute(name)?.Value ?? throw Wrong(element, $"{element.Name.LocalName} must have {name}.");

    /// <summary>A finite number as an attribute.</summary>
    /// <param name="element">The element.</param>
    /// <param name="name">Name of the attribute.</param>
    /// <param name="otherwise">The number where the attribute is missing; null if it is required.</param>
    public static double Number(this XElement element, string name, double? otherwise = null) =>
        element.Attribute(name) is null && otherwise is { } known ? known
        : double.TryParse(element.Text(name), NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && double.IsFinite(value)
            ? value
        : throw Wrong(element, $"{name} must be a finite number; parameters are not read.");

    /// <summary>The error of an element that has no counterpart.</summary>
    public static DatasetFormatException Unsupported(XElement element) =>
        Wrong(element, $"{element.Name.LocalName} is not supported; scenario import reads what scenario export writes.");

    /// <summary>An error at an element.</summary>
    public static DatasetFormatException Wrong(XElement element, string what) => new($"line {((IXmlLineInfo)element).LineNumber}: {what}");
}
