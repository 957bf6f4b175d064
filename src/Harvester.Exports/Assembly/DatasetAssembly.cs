using System.Text;
using System.Text.Json;
using Harvester.Datasets.Files;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Assembly;

/// <summary>
/// Assembles a finished dataset from the journals of all its shards: writes the aggregate files, the manifest and export.json, and deletes
/// the working folder.
/// </summary>
internal static class DatasetAssembly
{
    private static readonly UTF8Encoding Utf8 = new(encoderShouldEmitUTF8Identifier: false);

    public static ExportResult Finish(DatasetFolder folder, IReadOnlyList<string> journals)
    {
        string plan = folder.ReadPlan();
        string header = "";
        ExportResult? result = null;

        // Everything else is on the disk before the manifest, and the manifest before the file that says that the dataset is there.
        folder.Write(
            Manifest.FileName,
            stream =>
            {
                using var lines = new StreamWriter(stream, Utf8, leaveOpen: true) { NewLine = "\n" };
                var manifest = new DatasetManifest(lines);
                result = Assemble(folder, plan, journals, manifest);
                header = HeaderText(plan, result, manifest.Files + 1);
                manifest.Add(DatasetFolder.Header, FileDigest.Of(header));
                folder.Flush();
            }
        );
        folder.Flush();
        folder.Write(DatasetFolder.Header, stream => stream.Write(Utf8.GetBytes(header)));
        folder.Flush();
        folder.Finish();
        return result!;
    }

    /// <summary>The plan of a finished dataset.</summary>
    public static string PlanOf(DatasetFolder folder) => ReadHeader(folder, PlanIn);

    /// <summary>What a finished dataset says of itself.</summary>
    public static ExportResult ResultOf(DatasetFolder folder) =>
        ReadHeader(
            folder,
            static header =>
            {
                (DatasetFormat format, _) = ExportPlan.Parse(PlanIn(header));
                JsonFields splits = header.Fields("framesOfSplits");
                return new ExportResult(format, header.Integer("frames"), IsFinished: true)
                {
                    FramesLeftOut = header.Integer("framesLeftOut"),
                    Labels = header.Integer("labels"),
                    Posts = header.Has("posts") ? header.Integer("posts") : 0,
                    Objects = header.Integer("objects"),
                    Ignored = header.Integer("ignored"),
                    FramesOfSplits = splits.Names.ToDictionary(split => split, splits.Integer),
                };
            }
        );

    /// <summary>The plan in an export.json.</summary>
    /// <exception cref="DatasetFormatException">It has none.</exception>
    public static string PlanIn(JsonFields header) => header.RawText("plan");

    private static T ReadHeader<T>(DatasetFolder folder, Func<JsonFields, T> read)
    {
        try
        {
            using JsonDocument header = JsonInput.Read(folder.PathOf(DatasetFolder.Header));
            return read(new JsonFields(header.RootElement));
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException($"'{folder.Path}': {DatasetFolder.Header}: {JsonFault.InText(e)}", e);
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"'{folder.Path}': {DatasetFolder.Header} is malformed: {e.Message}", e);
        }
    }

    /// <summary>Writes the files about the whole dataset, and all files but export.json to the manifest.</summary>
    private static ExportResult Assemble(DatasetFolder folder, string plan, IReadOnlyList<string> journals, DatasetManifest manifest)
    {
        (DatasetFormat format, ExportOptions options) = ExportPlan.Parse(plan);
        FfmpegProgram.CheckFor(format);
        var parts = new PartStore(folder.PathOf(DatasetFolder.Working + "/parts"));
        SortedDictionary<string, int> splits = new(options.Splits.Splits.ToDictionary(split => split.Name, _ => 0), StringComparer.Ordinal);
        int leftOut = 0;
        int labels = 0;
        int posts = 0;
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
                    : throw new DatasetFormatException(
                        $"'{folder.Path}': frame {entry.Frame} is in the split '{entry.Split}', which the export does not have. Delete "
                            + "the folder and export again."
                    );
            }

            labels += entry.Labels;
            posts += format.HasParts ? entry.Posts : 0;
            objects += entry.Written.Objects;
            ignored += entry.Written.Ignored;
            manifest.AddFrame(entry.Files);
            foreach ((string name, string line) in entry.Parts)
            {
                parts.Add(name, line);
            }
        }

        parts.Flush();
        var result = new ExportResult(format, splits.Values.Sum(), IsFinished: true)
        {
            FramesLeftOut = leftOut,
            Labels = labels,
            Posts = posts,
            Objects = objects,
            Ignored = ignored,
            FramesOfSplits = splits,
        };
        var readme = new AggregateFile(DatasetFolder.Readme, [AggregateSection.Literal(DatasetReadme.Of(options, result))]);
        IDatasetWriter writer = format.CreateWriter(options);
        manifest.AddOthers([
            .. writer
                .Aggregates(parts.Counts)
                .Append(readme)
                .Select(file => KeyValuePair.Create(file.Path, folder.Write(file.Path, stream => Write(stream, file, parts, folder)))),
            .. writer.Tables.SelectMany(tables => Write(tables, parts, folder)),
        ]);
        return result;
    }

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
        using var output = new AggregateOutput(stream, parts, folder);
        foreach (AggregateSection section in file.Sections)
        {
            section.Write(output);
        }
    }

    /// <summary>Writes tables: opens one file within the other, then writes all of them.</summary>
    private static Dictionary<string, FileDigest> Write(AggregateTables tables, PartStore parts, DatasetFolder folder)
    {
        var digests = new Dictionary<string, FileDigest>(StringComparer.Ordinal);
        Open([]);
        return digests;

        void Open(IReadOnlyList<AggregateOutput> outputs)
        {
            if (outputs.Count == tables.Paths.Count)
            {
                tables.Write([.. outputs.Select(output => output.Text)], parts.Read(tables.Part));
                return;
            }

            string path = tables.Paths[outputs.Count];
            digests[path] = folder.Write(
                path,
                stream =>
                {
                    using var output = new AggregateOutput(stream, parts, folder);
                    Open([.. outputs, output]);
                }
            );
        }
    }

    private static string HeaderText(string plan, ExportResult result, int files) =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteNumber("formatVersion", 1);
            json.WriteNumber("frames", result.Frames);
            json.WriteNumber("framesLeftOut", result.FramesLeftOut);
            json.WriteNumber("labels", result.Labels);
            json.WriteNumber("posts", result.Posts);
            json.WriteNumber("objects", result.Objects);
            json.WriteNumber("ignored", result.Ignored);
            json.WriteNumber("files", files);
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
