using System.Text.Json;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>Checks nuScenes datasets: every table, every link between them, chains, and the files that they name.</summary>
internal sealed class NuScenesCheck(DatasetContent dataset)
{
    /// <summary>The fields that hold tokens of another table.</summary>
    private static readonly (string Table, string Field, string Target)[] Links =
    [
        ("calibrated_sensor", "sensor_token", "sensor"),
        ("instance", "category_token", "category"),
        ("instance", "first_annotation_token", "sample_annotation"),
        ("instance", "last_annotation_token", "sample_annotation"),
        ("sample", "scene_token", "scene"),
        ("sample_annotation", "sample_token", "sample"),
        ("sample_annotation", "instance_token", "instance"),
        ("sample_annotation", "visibility_token", "visibility"),
        ("sample_data", "sample_token", "sample"),
        ("sample_data", "ego_pose_token", "ego_pose"),
        ("sample_data", "calibrated_sensor_token", "calibrated_sensor"),
        ("scene", "log_token", "log"),
        ("scene", "first_sample_token", "sample"),
        ("scene", "last_sample_token", "sample"),
    ];

    private static readonly string[] Chains = ["sample", "sample_annotation", "sample_data"];

    /// <summary>Records are held in memory, about a kilobyte each.</summary>
    private const int MaxRecords = 500_000;

    /// <summary>Size of a table that is read as a whole.</summary>
    private const int MaxTableBytes = 64 << 20;

    private const string Begin = "[";
    private const string End = "]";
    private const string Empty = "[]";

    private readonly Dictionary<string, Dictionary<string, JsonFields>> _tables = new(StringComparer.Ordinal);
    private int _records;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset) => new NuScenesCheck(dataset).All();

    private static string FileOf(string table) => $"{NuScenesWriter.Version}/{table}.json";

    private List<SessionProblem> All()
    {
        var problems = new List<SessionProblem>();
        foreach (string table in NuScenesTables.Names)
        {
            if (ReadProblem(table) is { } problem && !IsList(table))
            {
                problems.Add(new SessionProblem(FileOf(table), null, problem));
            }
        }

        if (problems.Count > 0)
        {
            return problems;
        }

        Collect(problems, Links.Select(link => link.Table).Distinct(), LinkProblem);
        Collect(problems, Chains, ChainProblem);
        Collect(
            problems,
            ["sample_data", "map"],
            (_, record) => dataset.Has(record.Text("filename")) ? null : $"its file '{record.Text("filename")}' is missing."
        );
        Collect(problems, ["log"], (_, record) => NuScenesExpansions.ProblemOf(dataset, record.Text("location")));
        Collect(problems, ["sample_annotation"], (_, record) => AnnotationProblem(record));
        Collect(problems, ["ego_pose", "calibrated_sensor"], (_, record) => NuScenesGeometryCheck.PoseProblem(record));
        Collect(problems, ["calibrated_sensor"], (_, record) => IntrinsicsProblem(record));
        Collect(
            problems,
            ["ego_pose", "sample_annotation"],
            (_, record) => record.Numbers("translation", 3).Take(2).All(metres => metres >= 0) ? null : "it lies outside its map."
        );
        if (problems.Count == 0)
        {
            // Poses and boxes that are wrong by themselves say nothing of each other.
            problems.AddRange(GeometryProblems());
        }

        problems.AddRange(SegmentProblems());
        if (!dataset.Has(FileOf(NuScenesMapOffsets.Name)))
        {
            problems.Add(new SessionProblem(FileOf(NuScenesMapOffsets.Name), null, "it is missing."));
        }

        problems.AddRange(_tables["scene"].Values.SelectMany(scene => NuScenesCanBusCheck.Problems(dataset, scene.Text("name"))));
        if (SplitProblem() is { } split)
        {
            problems.Add(new SessionProblem(FileOf("splits"), null, split));
        }

        return problems;
    }

    /// <summary>
    /// Reads a table that other programs wrote, with other line breaks, as a whole. Whether it is a list of records whose tokens differ.
    /// </summary>
    private bool IsList(string table)
    {
        if (!dataset.Has(FileOf(table)))
        {
            return false;
        }

        var records = new Dictionary<string, JsonFields>(StringComparer.Ordinal);
        string? problem = Checked(() =>
        {
            using JsonDocument document = JsonInput.Parse(InputFile.ReadAllBytes(dataset.PathOf(FileOf(table)), MaxTableBytes));
            return document.RootElement.ValueKind != JsonValueKind.Array
                ? "it is no list."
                : document
                    .RootElement.EnumerateArray()
                    .Select(record => Add(new JsonFields(record.Clone()), records))
                    .FirstOrDefault(found => found is not null);
        });
        _tables[table] = records;
        return problem is null;
    }

    /// <summary>Reads a table line by line, as it is written: the records between a line for each bracket.</summary>
    private string? ReadProblem(string table)
    {
        if (!dataset.Has(FileOf(table)))
        {
            return "it is missing.";
        }

        var records = new Dictionary<string, JsonFields>(StringComparer.Ordinal);
        string last = "";
        foreach ((int number, string text) in dataset.Lines(FileOf(table)))
        {
            string? problem =
                last == End || last == Empty ? "a line follows the last."
                : number == 1
                    ? text is Begin or Empty ? null
                        : "it does not begin a list of records."
                : text == End
                    ? last.EndsWith(',') ? "a record must follow the comma."
                        : null
                : number > 2 && !last.EndsWith(',') ? "a comma must follow the record before."
                : Checked(() => RecordProblem(text, records));
            if (problem is not null)
            {
                return $"line {number}: {problem}";
            }

            last = text;
        }

        _tables[table] = records;
        return last is End or Empty ? null : "it is cut off.";
    }

    private string? RecordProblem(string text, Dictionary<string, JsonFields> records)
    {
        using JsonDocument document = JsonInput.Parse(text.EndsWith(',') ? text[..^1] : text);
        return Add(new JsonFields(document.RootElement.Clone()), records);
    }

    private string? Add(JsonFields record, Dictionary<string, JsonFields> records)
    {
        return !records.TryAdd(record.Text("token"), record) ? $"the token {record.Text("token")} occurs twice."
            : ++_records > MaxRecords ? $"the dataset has more than {MaxRecords} records, the limit of this check."
            : null;
    }

    /// <summary>Adds the first problem of each table: what is wrong with one record is usually wrong with many.</summary>
    private void Collect(List<SessionProblem> problems, IEnumerable<string> tables, Func<string, JsonFields, string?> problemOf)
    {
        foreach (string table in tables)
        {
            foreach ((string token, JsonFields record) in _tables[table])
            {
                if (Checked(() => problemOf(table, record)) is { } problem)
                {
                    problems.Add(new SessionProblem(FileOf(table), null, $"{token}: {problem}"));
                    break;
                }
            }
        }
    }

    private string? LinkProblem(string table, JsonFields record)
    {
        foreach ((_, string field, string target) in Links.Where(link => link.Table == table))
        {
            if (!_tables[target].ContainsKey(record.Text(field)))
            {
                return $"{field} is no token of {target}.";
            }
        }

        return null;
    }

    private string? ChainProblem(string table, JsonFields record)
    {
        string next = record.Text("next");
        string prev = record.Text("prev");
        return next.Length > 0 && !(_tables[table].TryGetValue(next, out JsonFields after) && after.Text("prev") == record.Text("token"))
                ? "the record after it does not point back."
            : prev.Length > 0 && !(_tables[table].TryGetValue(prev, out JsonFields before) && before.Text("next") == record.Text("token"))
                ? "the record before it does not point to it."
            : null;
    }

    private string? AnnotationProblem(JsonFields record)
    {
        double[] size = record.Numbers("size", 3);
        double[] rotation = record.Numbers("rotation", 4);
        const double rounding = 1e-6;
        return record.Numbers("translation", 3).Length != 3 || !Array.TrueForAll(size, side => side > 0) ? "its size is not above 0."
            : Math.Abs(rotation.Sum(part => part * part) - 1) > rounding ? "its rotation is no unit quaternion."
            : record.Integer("num_lidar_pts") < 0 || record.Integer("num_radar_pts") != 0 ? "its number of points is wrong."
            : record.Texts("attribute_tokens") is { Length: > 1 } ? "it has several attributes."
            : record.Texts("attribute_tokens").Any(token => !_tables["attribute"].ContainsKey(token)) ? "its attribute is unknown."
            : record.Has(NuScenesEvent.Field) && record.Texts(NuScenesEvent.Field).Any(token => !_tables["attribute"].ContainsKey(token))
                ? "the attribute of an event is unknown."
            : null;
    }

    private string? IntrinsicsProblem(JsonFields record) =>
        _tables["sensor"].TryGetValue(record.Text("sensor_token"), out JsonFields sensor)
        && sensor.Text("modality") == "camera"
        && record.Rows("camera_intrinsic", 3) is not [[> 0, 0, _], [0, > 0, _], [0, 0, 1]]
            ? "its camera_intrinsic is no camera matrix."
            : null;

    private IEnumerable<SessionProblem> GeometryProblems()
    {
        var check = new NuScenesGeometryCheck(dataset, _tables);
        if (Checked(check.LeaningProblem) is { } leaning)
        {
            return [new SessionProblem(FileOf("sample_annotation"), null, leaning)];
        }

        ILookup<string, JsonFields> data = _tables["sample_data"]
            .Values.Where(record => record.Boolean("is_key_frame"))
            .ToLookup(record => record.Text("sample_token"));
        foreach (string sample in _tables["sample"].Keys)
        {
            string? found = Checked(() => check.Problems(sample, [.. data[sample]]).FirstOrDefault());
            if (found is not null)
            {
                return [new SessionProblem(FileOf("sample_annotation"), null, found)];
            }
        }

        return [];
    }

    /// <summary>The first problem of each table of classes and instances of points; a dataset may have none of them.</summary>
    private IEnumerable<SessionProblem> SegmentProblems()
    {
        var check = new NuScenesSegmentCheck(dataset, _tables["sample_data"], _tables["category"]);
        foreach (string table in new[] { NuScenesSegments.Classes, NuScenesSegments.Instances }.Where(table => dataset.Has(FileOf(table))))
        {
            string? problem = ReadProblem(table) is { } text && !IsList(table) ? text : null;
            problem ??= Checked(() => check.ProblemOf(table, _tables[table]));
            if (problem is not null)
            {
                yield return new SessionProblem(FileOf(table), null, problem);
            }
        }
    }

    private string? SplitProblem() =>
        Checked(() =>
        {
            if (!dataset.Has(FileOf("splits")))
            {
                return "it is missing.";
            }

            using JsonDocument document = JsonInput.Read(dataset.PathOf(FileOf("splits")));
            var splits = new JsonFields(document.RootElement);
            ILookup<string, string> tokens = _tables["scene"].ToLookup(scene => scene.Value.Text("name"), scene => scene.Key);
            ILookup<string, string> files = _tables["sample_data"]
                .Values.Where(record => record.Integer("width") > 0 && _tables["sample"].ContainsKey(record.Text("sample_token")))
                .ToLookup(record => _tables["sample"][record.Text("sample_token")].Text("scene_token"), record => record.Text("filename"));
            int scenes = 0;
            foreach (string split in dataset.Splits)
            {
                string[] names = splits.Has(NuScenesSplits.NameOf(split)) ? splits.Texts(NuScenesSplits.NameOf(split)) : [];
                if (Array.Find(names, name => !tokens.Contains(name)) is { } unknown)
                {
                    return $"it has the unknown scene '{unknown}'.";
                }

                scenes += names.Length;
                dataset.Found(split, names.Sum(name => files[tokens[name].First()].Count()));
            }

            return scenes == tokens.Count ? null : "it does not have each scene once.";
        });

    private static string? Checked(Func<string?> check)
    {
        try
        {
            return check();
        }
        catch (Exception e) when (e is DatasetFormatException or JsonException)
        {
            return JsonFault.InText(e);
        }
    }
}
