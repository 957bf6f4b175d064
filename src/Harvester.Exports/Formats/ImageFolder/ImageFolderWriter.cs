using System.Text.Json;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.ImageFolder;

/// <summary>
/// Writes the image folders of Hugging Face's datasets: a folder per split with metadata.jsonl. See docs/exports/imagefolder.md.
/// </summary>
internal sealed class ImageFolderWriter(ExportOptions options) : IDatasetWriter
{
    /// <summary>Name of the table beside the images of a split.</summary>
    public const string Metadata = "metadata.jsonl";

    private const int Pixels = 3;

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string file = frame.Name + frame.ImageExtension;
        output.Image($"data/{frame.Split}/{file}", frame);
        output.Part(frame.Split, Row(frame, file));
        return new WrittenObjects(frame.Objects.Count, frame.Ignored.Count);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        options.Splits.Splits.Select(split => new AggregateFile($"data/{split.Name}/{Metadata}", [AggregateSection.Lines(split.Name)]));

    private static string Row(ExportFrame frame, string file) =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteString("file_name", file);
            json.WriteNumber("session", frame.RecordingIndex);
            json.WriteNumber("frame", frame.Label.Frame);
            json.WriteString("weather", frame.Label.Environment.Weather);
            json.WriteStartObject("objects");
            WriteBoxes(json, "bbox", frame.Objects.Select(item => item.Box));
            json.Numbers("categories", [.. frame.Objects.Select(item => (double)item.Class.Number)], 0);
            json.Numbers("track_ids", [.. frame.Objects.Select(item => (double)item.Label.Id)], 0);
            json.WriteEndObject();
            WriteBoxes(json, "ignore_regions", frame.Ignored.Select(region => region.Box));
            json.WriteEndObject();
        });

    private static void WriteBoxes(Utf8JsonWriter json, string name, IEnumerable<Box2D> boxes)
    {
        json.WriteStartArray(name);
        foreach (Box2D box in boxes)
        {
            json.Values([box.XMin, box.YMin, box.Width, box.Height], Pixels);
        }

        json.WriteEndArray();
    }
}
