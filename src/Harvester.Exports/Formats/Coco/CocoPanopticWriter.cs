using System.Text.Json;
using Harvester.Datasets.Masks.Pixels;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Semantics;

namespace Harvester.Exports.Formats.Coco;

/// <summary>
/// Writes COCO panoptic: a colour PNG per frame whose colours are segments, and a file per split that lists them. See
/// docs/exports/coco-panoptic.md.
/// </summary>
internal sealed class CocoPanopticWriter(ExportOptions options) : IDatasetWriter
{
    private const int Void = 0;

    private readonly PngEncoder _png = new();

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        InstanceMap mask = options.Parts == PartSelection.None ? frame.Mask! : frame.DividedMask!;
        IReadOnlyDictionary<int, InstancePixels> pixels = InstancePixels.AllOf(mask);
        ExportObject[] seen = [.. frame.Objects.Where(item => pixels.ContainsKey(item.Label.Id))];
        Dictionary<int, int> segments = seen.ToDictionary(item => item.Label.Id, item => item.Label.Id);
        foreach (ObjectLabel post in frame.Label.Objects.Where(frame.IsPost))
        {
            segments.Add(post.Id, Stuff.Pole.Segment);
        }

        if (frame.Classes is null)
        {
            segments.Add(0, Stuff.Background.Segment);
        }

        int[] surfaces = [.. Enumerable.Range(0, SemanticClasses.Greatest + 1).Select(value => Stuff.SegmentOf((SemanticClass)value))];
        var map = new SegmentMap(mask, id => segments.GetValueOrDefault(id, Void), frame.Classes, value => surfaces[value]);
        string image = frame.Name + frame.ImageExtension;
        output.Image($"images/{frame.Split}/{image}", frame);
        output.File($"annotations/panoptic_{frame.Split}/{frame.Name}.png", stream => _png.Write(map.Picture, stream));
        output.Part($"images {frame.Split}", CocoJson.Image(frame, image));
        output.Part($"annotations {frame.Split}", Annotation(frame, seen, map));
        return new WrittenObjects(seen.Length);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        CocoJson.Files("panoptic", options, StuffOf(options));

    /// <summary>
    /// The categories that are not objects. Without class maps, posts are one only if they are not part of their signs and lights.
    /// </summary>
    public static IEnumerable<Stuff> StuffOf(ExportOptions options) =>
        options.HasClassMaps ? Stuff.Surfaces
        : options.Parts == PartSelection.Faces ? [Stuff.Pole, Stuff.Background]
        : [Stuff.Background];

    private string Annotation(ExportFrame frame, ExportObject[] seen, SegmentMap map) =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteNumber("image_id", frame.Index);
            json.WriteString("file_name", frame.Name + ".png");
            json.WriteStartArray("segments_info");
            foreach (ExportObject item in seen)
            {
                WriteSegment(json, map.Segments[item.Label.Id], item.Class.Category);
            }

            foreach (Stuff stuff in StuffOf(options))
            {
                if (map.Segments.TryGetValue(stuff.Segment, out Segment? segment))
                {
                    WriteSegment(json, segment, stuff.Category);
                }
            }

            json.WriteEndArray();
            json.WriteEndObject();
        });

    private static void WriteSegment(Utf8JsonWriter json, Segment segment, int category)
    {
        json.WriteStartObject();
        json.WriteNumber("id", segment.Id);
        json.WriteNumber("category_id", category);
        json.Numbers(
            "bbox",
            [segment.Left, segment.Top, segment.Right - segment.Left, segment.Bottom - segment.Top],
            CocoJson.PixelDecimals
        );
        json.WriteNumber("area", segment.Area);
        json.WriteNumber("iscrowd", 0);
        json.WriteEndObject();
    }
}
