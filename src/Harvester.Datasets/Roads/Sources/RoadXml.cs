using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Xml;
using System.Xml.Linq;
using Harvester.Datasets.Files;

namespace Harvester.Datasets.Roads.Sources;

/// <summary>
/// Reads XML from strangers: no document type, so no entities; no outside references; limited in size. Errors name file and line.
/// </summary>
internal static class RoadXml
{
    /// <summary>Far above the size of a cell of the game's, which has about 1.5 million characters at most.</summary>
    private const long MaxWholeFile = XmlPartLimit.MaxElementBytes;

    /// <summary>The formats nest 6 deep.</summary>
    private const int MaxNesting = 32;

    private static readonly XmlReaderSettings Settings = Limited(RoadSource.MaxFileBytes);

    private static readonly XmlReaderSettings WholeSettings = Limited(MaxWholeFile);

    /// <summary>The outermost element of a file that is small enough to be held whole.</summary>
    public static XElement Root(RoadSource source)
    {
        RequireShallow(source, WholeSettings);
        using Stream stream = source.Open(new XmlPartLimit(source.Name));
        using XmlReader reader = XmlReader.Create(stream, WholeSettings);
        return Guarded(source, () => XElement.Load(reader, LoadOptions.SetLineInfo));
    }

    /// <summary>The outermost elements of a name, one after the other, each whole.</summary>
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

    /// <summary>An element of the name, which must be there.</summary>
    public static XElement Child(this XElement element, RoadSource source, string name) =>
        element.Element(name) ?? throw Wrong(source, element, $"{element.Name} has no {name}.");

    /// <summary>A whole number in an attribute.</summary>
    public static int Whole(this XElement element, RoadSource source, string attribute, int least, int most) =>
        int.TryParse(element.Attribute(attribute)?.Value, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value)
            && value >= least && value <= most
            ? value
            : throw Wrong(source, element, $"{element.Name} must have {attribute}, a whole number from {least} to {most}.");

    /// <summary>A finite number in an attribute.</summary>
    public static double Number(this XElement element, RoadSource source, string attribute) =>
        double.TryParse(element.Attribute(attribute)?.Value, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
            && double.IsFinite(value)
            ? value
            : throw Wrong(source, element, $"{element.Name} must have {attribute}, a finite number.");

    /// <summary>An error at an element.</summary>
    public static DatasetFormatException Wrong(RoadSource source, XElement element, string what) =>
        new($"{source.Name}, line {((IXmlLineInfo)element).LineNumber}: {what}");

    private static XmlReaderSettings Limited(long characters) => new()
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
    /// The reader itself has no limit of depth, and takes a time quadratic in it to word its error about elements left open.
    /// </summary>
    private static void RequireShallow(RoadSource source, XmlReaderSettings settings)
    {
        using Stream stream = source.Open(new XmlPartLimit(source.Name));
        using XmlReader reader = XmlReader.Create(stream, settings);
        while (Guarded(source, reader.Read))
        {
            if (reader.Depth > MaxNesting)
            {
                throw new DatasetFormatException($"{source.Name}, line {((IXmlLineInfo)reader).LineNumber}: elements are nested more than {MaxNesting} levels deep.");
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
            // A forbidden document type is refused without a line.
            string place = e.LineNumber > 0 ? $"line {e.LineNumber}" : "before the outermost element";
            string what = e.Message.Contains("DTD", StringComparison.Ordinal)
                ? "a document type (DTD) is refused: no file of roads has one." : e.Message;
            throw new DatasetFormatException($"{source.Name}, {place}: {what}", e);
        }
    }
}
