using System.Collections.Generic;
using System.Text.Json;
using Harvester.Capture.Labels;
using Harvester.Datasets.Exports.Masks;
using Harvester.Datasets.Json;
using Harvester.Geometry;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Exports.Coco;

/// <summary>COCO instances: images by split and one file of annotations for each. See docs/exports/coco.md.</summary>
internal sealed class CocoWriter(ExportOptions options) : IDatasetWriter
{
    /// <summary>Object ids fit 16 bits, so that frame and object together give an id that no filter and no shard changes.</summary>
    private const long IdsPerFrame = 65_536;

    public int Write(ExportFrame frame, FrameOutput output)
    {
        string file = frame.Name + frame.ImageExtension;
        output.Transfer($"images/{frame.Split}/{file}", frame.ImagePath);
        output.Part($"images {frame.Split}", CocoJson.Image(frame, file));
        IReadOnlyDictionary<int, InstancePixels>? pixels = frame.Mask is { } mask ? InstancePixels.AllOf(mask) : null;
        int written = 0;
        foreach (ObjectLabel label in frame.Objects)
        {
            // With a mask, an object of which no pixel is seen has nothing to annotate.
            InstancePixels? own = pixels?.GetValueOrDefault(label.Id);
            if (pixels is null || own is not null)
            {
                output.Part($"annotations {frame.Split}", Annotation(frame, label, own));
                written++;
            }
        }

        return written;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyCollection<string> parts) => CocoJson.Files("instances", options);

    private string Annotation(ExportFrame frame, ObjectLabel label, InstancePixels? pixels) => JsonLine.Of(json =>
    {
        Box2D box = pixels?.Box ?? label.Box2D;
        json.WriteStartObject();
        json.WriteNumber("id", (frame.Index * IdsPerFrame) + label.Id);
        json.WriteNumber("image_id", frame.Index);
        json.WriteNumber("category_id", CocoJson.CategoryOf(label.Class));
        json.Numbers("bbox", [box.XMin, box.YMin, box.Width, box.Height], CocoJson.PixelDecimals);
        json.Number("area", pixels?.Area ?? box.Area, CocoJson.PixelDecimals);
        json.WriteNumber("iscrowd", 0);
        json.WritePropertyName("segmentation");
        WriteSegmentation(json, pixels);
        json.WriteNumber("track_id", label.Id);
        json.Number("truncated_fraction", label.TruncatedFraction, CocoJson.FractionDecimals);
        json.Number("occluded_fraction", label.OccludedFraction, CocoJson.FractionDecimals);
        json.Number("distance_metres", label.DistanceMetres, CocoJson.PixelDecimals);
        json.WriteEndObject();
    });

    private void WriteSegmentation(Utf8JsonWriter json, InstancePixels? pixels)
    {
        if (pixels is null)
        {
            json.WriteStartArray();
            json.WriteEndArray();
        }
        else if (options.Segmentation == SegmentationKind.Rle)
        {
            WriteRunLengths(json, pixels);
        }
        else
        {
            json.WriteStartArray();
            foreach (IReadOnlyList<Vector2D> outline in pixels.Outlines())
            {
                json.WriteStartArray();
                foreach (Vector2D corner in outline)
                {
                    json.Value(corner.X, 0);
                    json.Value(corner.Y, 0);
                }

                json.WriteEndArray();
            }

            json.WriteEndArray();
        }
    }

    private static void WriteRunLengths(Utf8JsonWriter json, InstancePixels pixels)
    {
        json.WriteStartObject();
        json.WriteStartArray("size");
        json.WriteNumberValue(pixels.Map.Image.Height);
        json.WriteNumberValue(pixels.Map.Image.Width);
        json.WriteEndArray();
        json.WriteStartArray("counts");
        foreach (int count in MaskRuns.Encode(pixels.Map, pixels.Id))
        {
            json.WriteNumberValue(count);
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }
}
