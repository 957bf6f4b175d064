using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Bdd100K;

/// <summary>
/// Writes BDD100K: images by split, and a list of frames per split for the objects and another for the lane markings. See
/// docs/exports/bdd100k.md.
/// </summary>
internal sealed class Bdd100KWriter(ExportOptions options) : IDatasetWriter
{
    /// <summary>Folder of the images of a split.</summary>
    public const string Images = "images/100k/";

    private const string ObjectsPrefix = "objects ";
    private const string LanesPrefix = "lanes ";
    private const int Pixels = 3;
    private const double MillisecondsPerSecond = 1000;

    /// <summary>As in Pascal VOC's guidelines, from which the flags come: more than 5 % of the object is hidden, or outside.</summary>
    private const double FlagAbove = 0.05;

    /// <summary>The last pixel belongs to the box.</summary>
    private const double LastPixel = 1;

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string file = frame.Name + frame.ImageExtension;
        ExportRegion[] ignored = [.. frame.Ignored.Where(region => region.Class is not null)];
        output.Image($"{Images}{frame.Split}/{file}", frame);
        output.Part(
            ObjectsPrefix + frame.Split,
            Frame(
                frame,
                file,
                json =>
                {
                    foreach (ExportObject item in frame.Objects)
                    {
                        WriteObject(
                            json,
                            Numbers.Text(item.Label.Id),
                            Bdd100KClasses.Of(item.Label.Class, options.Names),
                            item.Box,
                            item.Label
                        );
                    }

                    for (int i = 0; i < ignored.Length; i++)
                    {
                        WriteObject(json, $"ignored-{i}", Bdd100KClasses.Of(ignored[i].Kind, options.Names), ignored[i].Box, null);
                    }
                }
            )
        );
        if (frame.Label.Lanes is { Status: LaneStatus.Known, Markings: { } markings })
        {
            output.Part(LanesPrefix + frame.Split, Frame(frame, file, json => WriteMarkings(json, markings)));
        }

        return new WrittenObjects(frame.Objects.Count, ignored.Length);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        options
            .Splits.Splits.Select(split => List(ObjectsOf(split.Name), ObjectsPrefix + split.Name))
            .Concat(
                options
                    .Splits.Splits.Where(split => parts.ContainsKey(LanesPrefix + split.Name))
                    .Select(split => List(LanesOf(split.Name), LanesPrefix + split.Name))
            );

    /// <summary>The list with the objects of a split.</summary>
    public static string ObjectsOf(string split) => $"labels/det_20/det_{split}.json";

    /// <summary>The list with the lane markings of a split.</summary>
    public static string LanesOf(string split) => $"labels/lane/polygons/lane_{split}.json";

    private static AggregateFile List(string path, string part) =>
        new(path, [AggregateSection.Literal("[\n"), AggregateSection.Joined(part, ",\n"), AggregateSection.Literal("\n]\n")]);

    private static string Frame(ExportFrame frame, string file, Action<Utf8JsonWriter> labels) =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteString("name", file);
            json.WriteString("videoName", $"sequence-{frame.SequenceIndex:D4}");
            json.WriteNumber("frameIndex", frame.FrameInSequence);
            json.Number("timestamp", frame.Label.TimeSeconds * MillisecondsPerSecond, 0);
            json.WriteStartObject("size");
            json.WriteNumber("width", frame.Label.Camera.Width);
            json.WriteNumber("height", frame.Label.Camera.Height);
            json.WriteEndObject();
            json.WriteStartObject("attributes");
            json.WriteString("weather", Bdd100KClasses.WeatherOf(frame.Label.Environment.Weather));
            json.WriteString("scene", Bdd100KClasses.Undefined);
            json.WriteString("timeofday", Bdd100KClasses.TimeOf(frame.Label.Environment.TimeOfDay));
            json.WriteEndObject();
            json.WriteStartArray("labels");
            labels(json);
            json.WriteEndArray();
            json.WriteEndObject();
        });

    private static void WriteObject(Utf8JsonWriter json, string id, string category, Box2D box, ObjectLabel? label)
    {
        json.WriteStartObject();
        json.WriteString("id", id);
        json.WriteString("category", category);
        json.WriteStartObject("attributes");
        json.WriteBoolean("occluded", label?.OccludedFraction > FlagAbove);
        json.WriteBoolean("truncated", label?.TruncatedFraction > FlagAbove);
        json.WriteBoolean("crowd", label is null);
        json.WriteString("trafficLightColor", Bdd100KClasses.LightOf(label?.Face?.Light?.State));
        json.WriteEndObject();
        json.WriteStartObject("box2d");
        json.Number("x1", box.XMin, Pixels);
        json.Number("y1", box.YMin, Pixels);
        json.Number("x2", box.XMax - LastPixel, Pixels);
        json.Number("y2", box.YMax - LastPixel, Pixels);
        json.WriteEndObject();
        json.WriteEndObject();
    }

    private static void WriteMarkings(Utf8JsonWriter json, IReadOnlyList<LaneLineView> markings)
    {
        int number = 0;
        foreach (LaneLineView marking in markings)
        {
            if (marking.Paint is { } paint)
            {
                json.WriteStartObject();
                json.WriteString("id", Numbers.Text(number++));
                json.WriteString("category", Bdd100KClasses.Of(paint));
                json.WriteStartObject("attributes");
                json.WriteString("laneDirection", "parallel");
                json.WriteString("laneStyle", paint.Style == MarkingStyle.Dashed ? "dashed" : "solid");
                json.WriteString("laneTypes", Bdd100KClasses.Of(paint));
                json.WriteEndObject();
                json.WriteStartArray("poly2d");
                json.WriteStartObject();
                json.WriteStartArray("vertices");
                foreach (LaneLinePoint point in marking.Points)
                {
                    json.Values([point.Pixel.X, point.Pixel.Y], Pixels);
                }

                json.WriteEndArray();
                json.WriteString("types", new string('L', marking.Points.Count));
                json.WriteBoolean("closed", false);
                json.WriteEndObject();
                json.WriteEndArray();
                json.WriteEndObject();
            }
        }
    }
}
