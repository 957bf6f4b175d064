using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Xml;
using Harvester.Capture.Labels;
using Harvester.Geometry;

namespace Harvester.Datasets.Exports.Voc;

/// <summary>Pascal VOC: JPEGImages, Annotations with one XML file a frame, ImageSets/Main. See docs/exports/voc.md.</summary>
internal sealed class VocWriter(ExportOptions options) : IDatasetWriter
{
    private const string ListPrefix = "list ";

    /// <summary>The challenge's guidelines: truncated when 15 to 20 % lie outside the box.</summary>
    private const double TruncatedFrom = 0.15;

    /// <summary>The guidelines: occluded when more than 5 % of the box are hidden.</summary>
    private const double OccludedFrom = 0.05;

    /// <summary>The guidelines leave it to the annotator what is difficult; here it is what is mostly unseen.</summary>
    private const double DifficultBelowVisible = 0.25;

    private static readonly XmlWriterSettings Settings = new()
    {
        Indent = true,
        IndentChars = "\t",
        NewLineChars = "\n",
        OmitXmlDeclaration = true,
        Encoding = new UTF8Encoding(false),
    };

    public int Write(ExportFrame frame, FrameOutput output)
    {
        string image = frame.Name + frame.ImageExtension;
        output.Transfer($"JPEGImages/{image}", frame.ImagePath);
        output.File($"Annotations/{frame.Name}.xml", stream => WriteXml(stream, frame, image));
        output.Part(ListPrefix + frame.Split, frame.Name);
        return frame.Objects.Count;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyCollection<string> parts) => options.Splits.Splits.Select(split =>
        new AggregateFile($"ImageSets/Main/{split.Name}.txt", [AggregateSection.Lines(ListPrefix + split.Name)]));

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
            foreach (ObjectLabel label in frame.Objects)
            {
                WriteObject(xml, label);
            }

            xml.WriteEndElement();
        }

        stream.WriteByte((byte)'\n');
    }

    private static void WriteObject(XmlWriter xml, ObjectLabel label)
    {
        Box2D box = label.Box2D;
        xml.WriteStartElement("object");
        xml.WriteElementString("name", JsonName.Of(label.Class));
        xml.WriteElementString("pose", "Unspecified");
        Write(xml, "truncated", label.TruncatedFraction >= TruncatedFrom ? 1 : 0);
        Write(xml, "occluded", label.OccludedFraction > OccludedFrom ? 1 : 0);
        Write(xml, "difficult", label.VisibleFraction < DifficultBelowVisible ? 1 : 0);

        // Pixels count from 1, and the last one belongs to the box: what begins in pixel i, from 0, begins in i + 1.
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
