using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using Harvester.Datasets.Files;
using Harvester.Datasets.Json;

namespace Harvester.Datasets.Exports.Assembly;

/// <summary>
/// Makes a finished dataset of the journals of all its shards: writes the aggregate files and export.json, and takes the working folder
/// away.
/// </summary>
internal static class DatasetAssembly
{
    public static ExportResult Finish(DatasetFolder folder, IReadOnlyList<string> journals)
    {
        string plan = folder.ReadPlan();
        (DatasetFormat format, ExportOptions options) = ExportPlan.Parse(plan);
        var parts = new PartStore(folder.PathOf(DatasetFolder.Working + "/parts"));
        SortedDictionary<string, int> splits = new(options.Splits.Splits.ToDictionary(split => split.Name, _ => 0), StringComparer.Ordinal);
        int leftOut = 0;
        int labels = 0;
        int objects = 0;
        int ignored = 0;
        foreach (JournalEntry entry in InOrder(journals))
        {
            if (entry.Files.Count == 0)
            {
                leftOut++;
            }
            else
            {
                splits[entry.Split] = splits.TryGetValue(entry.Split, out int frames)
                    ? frames + 1
                    : throw new DatasetFormatException($"'{folder.Path}': frame {entry.Frame} is in the split '{entry.Split}', which the export does not have. Begin the export anew.");
            }

            labels += entry.Labels;
            objects += entry.Written.Objects;
            ignored += entry.Written.Ignored;
            foreach ((string name, string line) in entry.Parts)
            {
                parts.Add(name, line);
            }
        }

        parts.Flush();
        foreach (AggregateFile file in format.CreateWriter(options).Aggregates(parts.Counts))
        {
            folder.Write(file.Path, stream => Write(stream, file, parts, folder));
        }

        var result = new ExportResult(format, splits.Values.Sum(), IsFinished: true)
        {
            FramesLeftOut = leftOut,
            Labels = labels,
            Objects = objects,
            Ignored = ignored,
            FramesOfSplits = splits
        };
        folder.Write(DatasetFolder.Manifest, stream => stream.Write(Encoding.UTF8.GetBytes(ManifestText(plan, result))));
        folder.Finish();
        return result;
    }

    /// <summary>The plan of a finished dataset.</summary>
    public static string PlanOf(DatasetFolder folder)
    {
        using JsonDocument manifest = ReadManifest(folder);
        return PlanIn(manifest);
    }

    /// <summary>What a finished dataset says of itself.</summary>
    public static ExportResult ResultOf(DatasetFolder folder)
    {
        using JsonDocument manifest = ReadManifest(folder);
        var fields = new JsonFields(manifest.RootElement);
        (DatasetFormat format, _) = ExportPlan.Parse(PlanIn(manifest));
        JsonFields splits = fields.Fields("framesOfSplits");
        return new ExportResult(format, fields.Integer("frames"), IsFinished: true)
        {
            FramesLeftOut = fields.Integer("framesLeftOut"),
            Labels = fields.Integer("labels"),
            Objects = fields.Integer("objects"),
            Ignored = fields.Integer("ignored"),
            FramesOfSplits = splits.Names.ToDictionary(split => split, splits.Integer),
        };
    }

    private static JsonDocument ReadManifest(DatasetFolder folder)
    {
        try
        {
            return JsonInput.Read(folder.PathOf(DatasetFolder.Manifest));
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException($"'{folder.Path}': {DatasetFolder.Manifest} is not JSON, line {e.LineNumber + 1}.", e);
        }
    }

    internal static string PlanIn(JsonDocument manifest) =>
        manifest.RootElement.ValueKind == JsonValueKind.Object && manifest.RootElement.TryGetProperty("plan", out JsonElement plan)
            ? plan.GetRawText()
            : throw new DatasetFormatException($"{DatasetFolder.Manifest} has no plan.");

    /// <summary>The entries of all journals by rising number; each journal is in order already.</summary>
    private static IEnumerable<JournalEntry> InOrder(IReadOnlyList<string> journals)
    {
        var heads = new PriorityQueue<IEnumerator<JournalEntry>, int>();
        foreach (string path in journals)
        {
            IEnumerator<JournalEntry> entries = Journal.Read(path).GetEnumerator();
            Advance(entries);
        }

        while (heads.TryDequeue(out IEnumerator<JournalEntry>? entries, out _))
        {
            yield return entries.Current;
            Advance(entries);
        }

        void Advance(IEnumerator<JournalEntry> entries)
        {
            if (entries.MoveNext())
            {
                heads.Enqueue(entries, entries.Current.Frame);
            }
            else
            {
                entries.Dispose();
            }
        }
    }

    private static void Write(Stream stream, AggregateFile file, PartStore parts, DatasetFolder folder)
    {
        using var writer = new StreamWriter(stream, new UTF8Encoding(false), leaveOpen: true);
        foreach (AggregateSection section in file.Sections)
        {
            writer.Write(section.Text);
            bool isFirst = true;
            foreach (string part in section.Part is null ? [] : parts.Read(section.Part))
            {
                writer.Write(isFirst ? "" : section.Between);
                isFirst = false;
                if (section.AreFiles)
                {
                    writer.Flush();
                    using FileStream staged = InputFile.OpenRead(folder.PathOf(part));
                    staged.CopyTo(stream);
                }
                else
                {
                    writer.Write(part);
                }

                writer.Write(section.After);
            }
        }
    }

    private static string ManifestText(string plan, ExportResult result) => JsonLine.Of(json =>
    {
        json.WriteStartObject();
        json.WriteNumber("formatVersion", 1);
        json.WriteNumber("frames", result.Frames);
        json.WriteNumber("framesLeftOut", result.FramesLeftOut);
        json.WriteNumber("labels", result.Labels);
        json.WriteNumber("objects", result.Objects);
        json.WriteNumber("ignored", result.Ignored);
        json.WriteStartObject("framesOfSplits");
        foreach ((string name, int count) in result.FramesOfSplits)
        {
            json.WriteNumber(name, count);
        }

        json.WriteEndObject();
        json.WritePropertyName("plan");
        json.WriteRawValue(plan);
        json.WriteEndObject();
    }) + "\n";
}
