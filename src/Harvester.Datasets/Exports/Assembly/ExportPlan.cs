using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text.Json;
using Harvester.Datasets.Exports.Formats;
using Harvester.Datasets.Files;
using Harvester.Datasets.Json;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Jpeg;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Exports.Assembly;

/// <summary>What an export does: which sessions become which dataset. Shards of one export have the same plan.</summary>
/// <param name="Format">The format.</param>
/// <param name="Sessions">The sessions, in order.</param>
/// <param name="Options">The options.</param>
public sealed record ExportPlan(DatasetFormat Format, IReadOnlyList<SessionReader> Sessions, ExportOptions Options)
{
    /// <summary>The plan as a text that is the same for the same export on any machine: sessions of one name differ by the digest of their session.json.</summary>
    internal string Identity => JsonLine.Of(json =>
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
            json.WriteStringValue(Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(session.PathOf(SessionInfo.FileName)))));
        }

        json.WriteEndArray();
        json.WriteStartObject("splits");
        foreach (DatasetSplit split in Options.Splits.Splits)
        {
            json.WriteNumber(split.Name, split.ShareFraction);
        }

        json.WriteEndObject();
        json.WriteNumber("splitSeed", Options.Splits.Seed);
        json.WriteNumber("splitBlockFrames", Options.Splits.BlockFrames);
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
        json.WriteNumber("minVisibleFraction", Options.MinVisibleFraction);
        WriteName(json, "parts", Options.Parts);
        WriteName(json, "boxes", Options.Boxes);
        json.WriteString("segmentation", JsonName.Of(Options.Segmentation));
        if (Options.ImageFormat is { } imageFormat)
        {
            json.WriteString("imageFormat", JsonName.Of(imageFormat));
            json.WriteNumber("quality", Options.JpegQuality);
        }

        json.WriteEndObject();
    });

    /// <summary>Reads from a plan's identity what assembling needs: format, splits and classes.</summary>
    internal static (DatasetFormat Format, ExportOptions Options) Parse(string identity)
    {
        using JsonDocument document = JsonDocument.Parse(identity);
        JsonElement root = document.RootElement;
        var fields = new JsonFields(root);
        string name = fields.Text("format");
        DatasetFormat format = DatasetFormats.Find(name) ?? throw new DatasetFormatException($"Unknown format '{name}'.");
        DatasetSplit[] splits = [.. root.GetProperty("splits").EnumerateObject().Select(split => new DatasetSplit(split.Name, split.Value.GetDouble()))];
        return (format, new ExportOptions
        {
            Splits = new SplitPlan(splits, fields.Integer("splitSeed"), fields.Integer("splitBlockFrames")),
            Classes = [.. fields.Text("classes").Split(',', StringSplitOptions.RemoveEmptyEntries).Select(ClassOf)],
            MinVisibleFraction = fields.Number("minVisibleFraction"),
            Names = root.GetProperty("names").EnumerateObject().ToDictionary(name => ClassOf(name.Name), name => name.Value.GetString()!),
            Subclasses = (Subclasses)fields.Integer("subclasses"),
            MutcdCodes = [.. root.GetProperty("mutcdCodes").EnumerateArray().Select(code => code.GetString()!)],
            Parts = fields.Has("parts") ? fields.Name<PartSelection>("parts") : null,
            Boxes = fields.Has("boxes") ? fields.Name<BoxKind>("boxes") : null,
            Segmentation = fields.Name<SegmentationKind>("segmentation"),
            ImageFormat = fields.Has("imageFormat") ? fields.Name<ImageFormat>("imageFormat") : null,
            JpegQuality = fields.Has("imageFormat") ? fields.Integer("quality") : JpegEncoder.DefaultQuality,
        });
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
