using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using System.Text.Json;
using Harvester.Exports.Formats;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Jpeg;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Roads;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Assembly;

/// <summary>The plan of an export: format, sessions and options. Shards of one export have the same plan.</summary>
/// <param name="Format">The format.</param>
/// <param name="Sessions">The sessions, in order.</param>
/// <param name="Options">The options.</param>
public sealed record ExportPlan(DatasetFormat Format, IReadOnlyList<SessionReader> Sessions, ExportOptions Options)
{
    /// <summary>
    /// The plan as text, equal for equal exports on any machine. Sessions of the same name differ by the hash of their session.json.
    /// </summary>
    internal string Identity =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteString("format", Format.Name);
            json.WriteStartArray("sessions");
            foreach (SessionReader session in Sessions)
            {
                json.WriteStringValue(Path.GetFileName(Path.TrimEndingDirectorySeparator(Path.GetFullPath(session.Folder))));
            }

            json.WriteEndArray();
            json.WriteStartArray("sessionDigests");
            foreach (SessionReader session in Sessions)
            {
                json.WriteStringValue(
                    Convert.ToHexStringLower(SHA256.HashData(InputFile.ReadAllBytes(session.PathOf(SessionInfo.FileName))))
                );
            }

            json.WriteEndArray();
            json.WriteStartObject("splits");
            foreach (DatasetSplit split in Options.Splits.Splits)
            {
                json.WriteNumber(split.Name, split.ShareFraction);
            }

            json.WriteEndObject();
            json.WriteNumber("splitSeed", Options.Splits.Seed);
            if (Options.Splits.BlockFrames is { } block)
            {
                json.WriteNumber("splitBlockFrames", block);
            }

            json.WriteString("classes", string.Join(',', Options.ClassList.Select(JsonName.Of)));
            json.WriteStartObject("names");
            foreach ((ObjectClass kind, string name) in Options.Names.OrderBy(pair => pair.Key))
            {
                json.WriteString(JsonName.Of(kind), name);
            }

            json.WriteEndObject();
            json.WriteNumber("subclasses", (int)Options.Subclasses);
            json.WriteStartArray("mutcdCodes");
            foreach (string code in Options.MutcdCodes)
            {
                json.WriteStringValue(code);
            }

            json.WriteEndArray();
            if (Options.HasClassMaps)
            {
                json.WriteBoolean("classMaps", true);
            }

            json.WriteNumber("minVisibleFraction", Options.MinVisibleFraction);
            WriteName(json, "parts", Options.Parts);
            WriteName(json, "boxes", Options.Boxes);
            json.WriteString("segmentation", JsonName.Of(Options.Segmentation));
            if (Options.Lanes != default)
            {
                json.WriteString("lanes", JsonName.Of(Options.Lanes));
            }

            if (Options.Roads is { } roads)
            {
                json.WriteString("roads", Options.RoadsName);
                json.WriteString("roadsSha256", DigestOf(roads));
            }

            if (Options.ImageFormat is { } imageFormat)
            {
                json.WriteString("imageFormat", JsonName.Of(imageFormat));
                json.WriteNumber("quality", Options.JpegQuality);
            }

            json.WriteEndObject();
        });

    /// <summary>Reads the parts of a plan that assembly needs: format, splits and classes.</summary>
    /// <exception cref="DatasetFormatException">The plan is damaged, or of another version.</exception>
    internal static (DatasetFormat Format, ExportOptions Options) Parse(string identity)
    {
        try
        {
            using JsonDocument document = JsonInput.Parse(identity);
            return Parse(new JsonFields(document.RootElement));
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException($"The plan of the export: {JsonFault.InLine(e)} Delete the folder and export again.", e);
        }
    }

    private static (DatasetFormat Format, ExportOptions Options) Parse(JsonFields plan)
    {
        string name = plan.Text("format");
        DatasetFormat format = DatasetFormats.Find(name) ?? throw new DatasetFormatException($"Unknown format '{name}'.");
        JsonFields splits = plan.Fields("splits");
        JsonFields names = plan.Fields("names");
        return (
            format,
            new ExportOptions
            {
                Splits = plan.Checked(() =>
                    new SplitPlan(
                        [.. splits.Names.Select(split => new DatasetSplit(split, splits.Number(split)))],
                        plan.Integer("splitSeed"),
                        plan.Has("splitBlockFrames") ? plan.Integer("splitBlockFrames") : null
                    )
                ),
                Classes = [.. plan.Text("classes").Split(',', StringSplitOptions.RemoveEmptyEntries).Select(ClassOf)],
                MinVisibleFraction = plan.Number("minVisibleFraction"),
                Names = names.Names.ToDictionary(ClassOf, names.Text),
                Subclasses = (Subclasses)plan.Integer("subclasses"),
                MutcdCodes = plan.Texts("mutcdCodes"),
                HasClassMaps = plan.Has("classMaps") && plan.Boolean("classMaps"),
                Parts = plan.Has("parts") ? plan.Name<PartSelection>("parts") : null,
                Boxes = plan.Has("boxes") ? plan.Name<BoxKind>("boxes") : null,
                Segmentation = plan.Name<SegmentationKind>("segmentation"),
                Lanes = plan.Has("lanes") ? plan.Name<LaneSelection>("lanes") : default,
                RoadsName = plan.OptionalText("roads"),
                ImageFormat = plan.Has("imageFormat") ? plan.Name<ImageFormat>("imageFormat") : null,
                JpegQuality = plan.Has("imageFormat") ? plan.Integer("quality") : JpegEncoder.DefaultQuality,
            }
        );
    }

    private static string DigestOf(RoadNetwork roads)
    {
        using var text = new StringWriter(CultureInfo.InvariantCulture);
        RoadCsvWriter.Write(roads, text);
        return Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(text.ToString())));
    }

    private static void WriteName<T>(Utf8JsonWriter json, string key, T? value)
        where T : struct, Enum
    {
        if (value is { } known)
        {
            json.WriteString(key, JsonName.Of(known));
        }
        else
        {
            json.WriteNull(key);
        }
    }

    private static ObjectClass ClassOf(string name) =>
        JsonNames.TryRead(name, out ObjectClass kind) ? kind : throw new DatasetFormatException($"Unknown class '{name}'.");
}
