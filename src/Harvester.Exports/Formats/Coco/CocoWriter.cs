using System.Text.Json;
using Harvester.Datasets.Masks.Pixels;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.Coco;

/// <summary>Writes COCO instances: images by split, and an annotation file per split. See docs/exports/coco.md.</summary>
internal sealed class CocoWriter(ExportOptions options) : IDatasetWriter
{
    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string file = frame.Name + frame.ImageExtension;
        output.Image($"images/{frame.Split}/{file}", frame);
        output.Part($"images {frame.Split}", CocoJson.Image(frame, file));
        int objects = 0;
        foreach (ExportObject item in frame.Objects)
        {
            // With a mask, an object without visible pixels has nothing to annotate.
            InstancePixels? pixels = frame.PixelsOf(item.Label);
            if (frame.Mask is null || pixels is not null)
            {
                var segmentation = new CocoSegmentation(options.Segmentation, pixels);
                output.Part(
                    $"annotations {frame.Split}",
                    Annotation(frame, item.Label.Id, item.Class, item.Box, isCrowd: false, segmentation, item.Label)
                );
                objects++;
            }
        }

        int ignored = 0;
        foreach (ExportRegion region in frame.Ignored)
        {
            if (region.Class is { } kind)
            {
                CocoSegmentation segmentation = CocoSegmentation.OfRegion(region, frame);
                int id = region.Label?.Id ?? CocoIds.FirstRegion + ignored;
                output.Part(
                    $"annotations {frame.Split}",
                    Annotation(frame, id, kind, region.Box, isCrowd: true, segmentation, region.Label)
                );
                ignored++;
            }
        }

        return new WrittenObjects(objects, ignored);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) => CocoJson.Files("instances", options);

    private static string Annotation(
        ExportFrame frame,
        int id,
        DatasetClass kind,
        Box2D box,
        bool isCrowd,
        CocoSegmentation segmentation,
        ObjectLabel? label
    ) =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteNumber("id", CocoIds.Of(frame, id));
            json.WriteNumber("image_id", frame.Index);
            json.WriteNumber("category_id", kind.Category);
            json.Numbers("bbox", [box.XMin, box.YMin, box.Width, box.Height], CocoJson.PixelDecimals);
            json.Number("area", segmentation.Area ?? box.Area, CocoJson.PixelDecimals);
            json.WriteNumber("iscrowd", isCrowd ? 1 : 0);
            json.WritePropertyName("segmentation");
            segmentation.Write(json);
            if (label is not null)
            {
                WriteExtras(json, label);
            }

            json.WriteEndObject();
        });

    /// <summary>Fields of the session that the format does not define.</summary>
    private static void WriteExtras(Utf8JsonWriter json, ObjectLabel label)
    {
        json.WriteNumber("track_id", label.Id);
        json.Number("truncated_fraction", label.TruncatedFraction, CocoJson.FractionDecimals);
        json.Number("occluded_fraction", label.OccludedFraction, CocoJson.FractionDecimals);
        json.Number("distance_metres", label.DistanceMetres, CocoJson.PixelDecimals);
        json.WriteString("mutcd", label.Face?.MutcdCode);
        json.WriteString("light_state", label.Face?.Light is { } light ? JsonName.Of(light.State) : null);
    }
}
