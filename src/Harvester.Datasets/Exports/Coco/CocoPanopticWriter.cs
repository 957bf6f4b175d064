using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Harvester.Capture.Imaging;
using Harvester.Capture.Labels;
using Harvester.Datasets.Exports.Masks;
using Harvester.Datasets.Json;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Exports.Coco;

/// <summary>COCO panoptic: a colour PNG a frame whose colours are segments, and their list in one file a split. See docs/exports/coco-panoptic.md.</summary>
internal sealed class CocoPanopticWriter(ExportOptions options) : IDatasetWriter
{
    private readonly PngEncoder _png = new();

    public int Write(ExportFrame frame, FrameOutput output)
    {
        InstanceMap mask = frame.Mask!;
        IReadOnlyDictionary<int, InstancePixels> pixels = InstancePixels.AllOf(mask);
        ObjectLabel[] seen = [.. frame.Objects.Where(label => pixels.ContainsKey(label.Id))];
        string image = frame.Name + frame.ImageExtension;
        output.Transfer($"images/{frame.Split}/{image}", frame.ImagePath);
        output.File($"annotations/panoptic_{frame.Split}/{frame.Name}.png", stream => _png.Write(Colours(mask, [.. seen.Select(label => label.Id)]), stream));
        output.Part($"images {frame.Split}", CocoJson.Image(frame, image));
        output.Part($"annotations {frame.Split}", Annotation(frame, seen, pixels));
        return seen.Length;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyCollection<string> parts) => CocoJson.Files("panoptic", options);

    /// <summary>A segment's id is its colour, red + 256 green + 65536 blue; here it is the object's, and black is no segment.</summary>
    private static PixelBuffer Colours(InstanceMap mask, HashSet<int> ids)
    {
        var picture = new PixelBuffer(mask.Image);
        for (int i = 0; i < mask.Ids.Length; i++)
        {
            if (ids.Contains(mask.Ids[i]))
            {
                picture.Bytes[i * PixelBuffer.BytesPerPixel] = (byte)mask.Ids[i];
                picture.Bytes[(i * PixelBuffer.BytesPerPixel) + 1] = (byte)(mask.Ids[i] >> 8);
            }
        }

        return picture;
    }

    private static string Annotation(ExportFrame frame, ObjectLabel[] seen, IReadOnlyDictionary<int, InstancePixels> pixels) => JsonLine.Of(json =>
    {
        json.WriteStartObject();
        json.WriteNumber("image_id", frame.Index);
        json.WriteString("file_name", frame.Name + ".png");
        json.WriteStartArray("segments_info");
        foreach (ObjectLabel label in seen)
        {
            WriteSegment(json, label, pixels[label.Id]);
        }

        json.WriteEndArray();
        json.WriteEndObject();
    });

    private static void WriteSegment(Utf8JsonWriter json, ObjectLabel label, InstancePixels pixels)
    {
        json.WriteStartObject();
        json.WriteNumber("id", label.Id);
        json.WriteNumber("category_id", CocoJson.CategoryOf(label.Class));
        json.Numbers("bbox", [pixels.Left, pixels.Top, pixels.Box.Width, pixels.Box.Height], CocoJson.PixelDecimals);
        json.WriteNumber("area", pixels.Area);
        json.WriteNumber("iscrowd", 0);
        json.WriteEndObject();
    }
}
