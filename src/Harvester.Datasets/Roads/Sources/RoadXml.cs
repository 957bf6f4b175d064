using System.Globalization;
using System.Xml;
using System.Xml.Linq;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Roads.Sources;

/// <summary>
/// Reads untrusted XML: no document type (and so no entities), no external references, limited size. Errors name file and line.
/// </summary>
internal static class RoadXml
{
    /// <summary>Far above the size of a cell of the game, which has at most about 1.5 million characters.</summary>
    private const long MaxWholeFile = XmlPartLimit.MaxElementBytes;

    /// <summary>The formats have 6 levels of nesting.</summary>
    private const int MaxNesting = 32;

    private static readonly XmlReaderSettings Settings = Limited(RoadSource.MaxFileBytes);

    private static readonly XmlReaderSettings WholeSettings = Limited(MaxWholeFile);

    /// <summary>The root element of a file that is small enough to be held in memory.</summary>
    public static XElement Root(RoadSource source)
    {
        RequireShallow(source, WholeSettings);
        using Stream stream = source.Open(new XmlPartLimit(source.Name));
        using XmlReader reader = XmlReader.Create(stream, WholeSettings);
        return Guarded(source, () => XElement.Load(reader, LoadOptions.SetLineInfo));
    }

    /// <summary>The outermost elements of a name, one by one, each held in memory.</summary>
    public static IEnumerable<XElement> Elements(RoadSource source, string name)
    {
        RequireShallow(source, Settings);
        var limit = new XmlPartLimit(source.Name);
        using Stream stream = source.Open(limit);
        using XmlReader reader = XmlReader.Create(stream, Settings);
        while (Guarded(source, () => reader.ReadToFollowing(name)))
        {
            limit.IsTaking = true;
            XElement element = Guarded(source, () => Take(reader));
            limit.IsTaking = false;
            yield return element;
        }
    }

    /// <summary>A required child element.</summary>
    public static XElement Child(this XElement element, RoadSource source, string name) =>
        element.Element(name) ?? throw Wrong(source, element, $"{element.Name} has no {name}.");

    /// <summary>An integer attribute.</summary>
    public static int Whole(this XElement element, RoadSource source, string attribute, int min, int max) =>
        int.TryParse(element.Attribute(attribute)?.Value, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value)
        && value >= min
        && value <= max
            ? value
            : throw Wrong(source, element, $"{element.Name} must have {attribute}, a whole number from {min} to {max}.");

    /// <summary>A finite number attribute.</summary>
    public static double Number(this XElement element, RoadSource source, string attribute) =>
        double.TryParse(element.Attribute(attribute)?.Value, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
        && double.IsFinite(value)
            ? value
            : throw Wrong(source, element, $"{element.Name} must have {attribute}, a finite number.");

    /// <summary>An error at an element.</summary>
    public static DatasetFormatException Wrong(RoadSource source, XElement element, string what) =>
        new($"{source.Name}, line {((IXmlLineInfo)element).LineNumber}: {what}");

    private static XmlReaderSettings Limited(long characters) =>
        new()
        {
            DtdProcessing = DtdProcessing.Prohibit,
            XmlResolver = null,
            MaxCharactersInDocument = characters,
            IgnoreComments = true,
            IgnoreWhitespace = true,
            IgnoreProcessingInstructions = true,
        };

    private static XElement Take(XmlReader reader)
    {
        using XmlReader subtree = reader.ReadSubtree();
        return XElement.Load(subtree, LoadOptions.SetLineInfo);
    }

    /// <summary>
    /// Limits the depth of nesting, which the reader itself does not. Its error for unclosed elements takes quadratic time in the depth.
    /// </summary>
    private static void RequireShallow(RoadSource source, XmlReaderSettings settings)
    {
        using Stream stream = source.Open(new XmlPartLimit(source.Name));
        using XmlReader reader = XmlReader.Create(stream, settings);
        while (Guarded(source, reader.Read))
        {
            if (reader.Depth > MaxNesting)
            {
                throw new DatasetFormatException(
                    $"{source.Name}, line {((IXmlLineInfo)reader).LineNumber}: elements are nested more than {MaxNesting} levels deep."
                );
            }
        }
    }

    private static T Guarded<T>(RoadSource source, Func<T> read)
    {
        try
        {
            return read();
        }
        catch (XmlException e)
        {
            // The error for a document type has no line number.
            string place = e.LineNumber > 0 ? $"line {e.LineNumber}" : "before the outermost element";
            string what = e.Message.Contains("DTD", StringComparison.Ordinal) ? "document types (DTDs) are not allowed." : e.Message;
            throw new DatasetFormatException($"{source.Name}, {place}: {what}", e);
        }
    }
}
