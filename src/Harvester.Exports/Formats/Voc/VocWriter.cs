using System.Globalization;
using System.Text;
using System.Xml;
using Harvester.Datasets.Colours;
using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Formats.Voc;

/// <summary>Writes Pascal VOC: JPEGImages, Annotations with one XML file per frame, ImageSets/Main. See docs/exports/voc.md.</summary>
internal sealed class VocWriter(ExportOptions options) : IDatasetWriter
{
    /// <summary>Name of the file that lists the classes.</summary>
    public const string LabelMapFile = "labelmap.txt";

    private const string ListPrefix = "list ";

    /// <summary>The challenge's guidelines: truncated if 15 to 20 % lie outside the box.</summary>
    private const double TruncatedFrom = 0.15;

    /// <summary>The guidelines: occluded if more than 5 % of the box is hidden.</summary>
    private const double OccludedFrom = 0.05;

    /// <summary>The guidelines leave "difficult" to the annotator; here, it means mostly hidden.</summary>
    private const double DifficultBelowVisible = 0.25;

    private static readonly XmlWriterSettings Settings = new()
    {
        Indent = true,
        IndentChars = "\t",
        NewLineChars = "\n",
        OmitXmlDeclaration = true,
        Encoding = new UTF8Encoding(false),
    };

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string image = frame.Name + frame.ImageExtension;
        output.Image($"JPEGImages/{image}", frame);
        output.File($"Annotations/{frame.Name}.xml", stream => WriteXml(stream, frame, image));
        output.Part(ListPrefix + frame.Split, frame.Name);
        return new WrittenObjects(frame.Objects.Count, frame.Ignored.Count(region => region.Class is not null));
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        options
            .Splits.Splits.Select(split => new AggregateFile(
                $"ImageSets/Main/{split.Name}.txt",
                [AggregateSection.Lines(ListPrefix + split.Name)]
            ))
            .Append(LabelMap());

    /// <summary>The classes with colours, in the format that annotation tools read.</summary>
    private AggregateFile LabelMap()
    {
        var text = new StringBuilder("# label:color_rgb:parts:actions\nbackground:0,0,0::\n");
        foreach (DatasetClass kind in new ClassCatalogue(options).All)
        {
            int colour = ClassColours.Of(kind.Kind);
            text.Append(CultureInfo.InvariantCulture, $"{kind.Name}:{colour >> 16},{(colour >> 8) & 0xFF},{colour & 0xFF}::\n");
        }

        return new AggregateFile(LabelMapFile, [AggregateSection.Literal(text.ToString())]);
    }

    private static void WriteXml(Stream stream, ExportFrame frame, string image)
    {
        using (var xml = XmlWriter.Create(stream, Settings))
        {
            xml.WriteStartElement("annotation");
            xml.WriteElementString("folder", "JPEGImages");
            xml.WriteElementString("filename", image);
            xml.WriteStartElement("source");
            xml.WriteElementString("database", "GtaDataHarvester");
            xml.WriteEndElement();
            xml.WriteStartElement("size");
            Write(xml, "width", frame.Label.Camera.Width);
            Write(xml, "height", frame.Label.Camera.Height);
            Write(xml, "depth", 3);
            xml.WriteEndElement();
            Write(xml, "segmented", 0);
            foreach (ExportObject item in frame.Objects)
            {
                WriteObject(xml, item.Class, item.Box, item.Label, isIgnored: false);
            }

            foreach (ExportRegion region in frame.Ignored)
            {
                if (region.Class is { } kind)
                {
                    WriteObject(xml, kind, region.Box, region.Label, isIgnored: true);
                }
            }

            xml.WriteEndElement();
        }

        stream.WriteByte((byte)'\n');
    }

    private static void WriteObject(XmlWriter xml, DatasetClass kind, Box2D box, ObjectLabel? label, bool isIgnored)
    {
        xml.WriteStartElement("object");
        xml.WriteElementString("name", kind.Name);
        xml.WriteElementString("pose", "Unspecified");
        Write(xml, "truncated", label?.TruncatedFraction >= TruncatedFrom ? 1 : 0);
        Write(xml, "occluded", label?.OccludedFraction > OccludedFrom ? 1 : 0);
        Write(xml, "difficult", isIgnored || label?.VisibleFraction < DifficultBelowVisible ? 1 : 0);

        // Pixels count from 1 and the last one is inside the box, so pixel i, counted from 0, becomes i + 1.
        xml.WriteStartElement("bndbox");
        Write(xml, "xmin", (int)Math.Floor(box.XMin) + 1);
        Write(xml, "ymin", (int)Math.Floor(box.YMin) + 1);
        Write(xml, "xmax", (int)Math.Ceiling(box.XMax));
        Write(xml, "ymax", (int)Math.Ceiling(box.YMax));
        xml.WriteEndElement();
        xml.WriteEndElement();
    }

    private static void Write(XmlWriter xml, string name, int value) => xml.WriteElementString(name, Numbers.Text(value));
}
