using System.Text.Json;
using Harvester.Datasets.Colours;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.Coco;

/// <summary>The JSON that COCO files have in common.</summary>
internal static class CocoJson
{
    public const int PixelDecimals = 3;
    public const int FractionDecimals = 4;
    private const int SecondsDecimals = 6;

    /// <summary>The info object; without a date, so that the same sessions give the same bytes.</summary>
    private const string Info = """{"description":"Exported by GtaDataHarvester","version":"1"}""";

    /// <summary>The files of all splits, assembled from parts named images and annotations with the split.</summary>
    /// <param name="kind">Prefix of their names.</param>
    /// <param name="options">The options.</param>
    /// <param name="stuff">Categories that are not objects.</param>
    public static IEnumerable<AggregateFile> Files(string kind, ExportOptions options, params IEnumerable<Stuff> stuff) =>
        Files(kind, options.Splits, Categories(options, stuff));

    /// <summary>As above, with the list of categories as JSON.</summary>
    public static IEnumerable<AggregateFile> Files(string kind, SplitPlan splits, string categories) =>
        splits.Splits.Select(split => new AggregateFile(
            $"annotations/{kind}_{split.Name}.json",
            [
                AggregateSection.Literal("{\"info\":" + Info + ",\"licenses\":[],\"images\":[\n"),
                AggregateSection.Joined($"images {split.Name}", ",\n"),
                AggregateSection.Literal("\n],\"annotations\":[\n"),
                AggregateSection.Joined($"annotations {split.Name}", ",\n"),
                AggregateSection.Literal("\n],\"categories\":" + categories + "}\n"),
            ]
        ));

    /// <summary>The list of categories.</summary>
    private static string Categories(ExportOptions options, IEnumerable<Stuff> stuff) =>
        JsonLine.Of(json =>
        {
            json.WriteStartArray();
            foreach (DatasetClass kind in new ClassCatalogue(options).All)
            {
                WriteCategory(json, kind.Category, kind.Name, SuperCategoryOf(kind.Kind), isThing: true, ClassColours.Of(kind.Kind));
            }

            foreach (Stuff kind in stuff)
            {
                WriteCategory(json, kind.Category, kind.Name, "stuff", isThing: false, kind.Colour);
            }

            json.WriteEndArray();
        });

    private static void WriteCategory(Utf8JsonWriter json, int id, string name, string superCategory, bool isThing, int colour)
    {
        json.WriteStartObject();
        json.WriteNumber("id", id);
        json.WriteString("name", name);
        json.WriteString("supercategory", superCategory);
        json.WriteNumber("isthing", isThing ? 1 : 0);
        json.Numbers("color", [colour >> 16, (colour >> 8) & 0xFF, colour & 0xFF], 0);
        json.WriteEndObject();
    }

    /// <summary>An entry of the list of images.</summary>
    public static string Image(ExportFrame frame, string file) =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteNumber("id", frame.Index);
            json.WriteString("file_name", file);
            json.WriteNumber("width", frame.Label.Camera.Width);
            json.WriteNumber("height", frame.Label.Camera.Height);
            json.WriteNumber("session", frame.RecordingIndex);
            json.WriteNumber("frame", frame.Label.Frame);
            json.Number("time_seconds", frame.Label.TimeSeconds, SecondsDecimals);
            json.WriteString("weather", frame.Label.Environment.Weather);
            json.WriteEndObject();
        });

    private static string SuperCategoryOf(ObjectClass kind) =>
        kind switch
        {
            ObjectClass.Pedestrian or ObjectClass.Rider => "person",
            ObjectClass.Sign or ObjectClass.TrafficLight => "outdoor",
            ObjectClass.Other => "other",
            _ => "vehicle",
        };
}
