using System.Text.Json;
using Harvester.Geometry;
using Harvester.Reports.Sessions;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Reports.Comparison;

/// <summary>
/// The key frames of nuScenes' cameras as a dataset to compare: its annotations, projected into each image. Tables are streamed; what is
/// held grows with the number of key frames.
/// </summary>
public sealed class ComparedNuScenes : IComparedDataset
{
    /// <summary>The full dataset has 64,386 instances and 204,894 images of key frames.</summary>
    private const int MaxRecords = 500_000;

    private const int BytesPerUnit = 1_000_000;
    private const int QuaternionNumbers = 4;
    private const int VectorNumbers = 3;
    private static readonly string[] Tables =
    [
        "category",
        "instance",
        "sensor",
        "calibrated_sensor",
        "sample_data",
        "ego_pose",
        "sample_annotation",
    ];

    private readonly string _folder;
    private readonly string _tables;
    private readonly List<string> _images = [];
    private long _bytesBefore;
    private Action<int> _report = _ => { };

    private ComparedNuScenes(string folder, string tables)
    {
        _folder = folder;
        _tables = tables;
        Length = (int)(Tables.Sum(table => new FileInfo(PathOf(table)).Length) / BytesPerUnit) + 1;
    }

    /// <inheritdoc />
    public int Length { get; }

    /// <inheritdoc />
    public string Unit => "MB";

    /// <inheritdoc />
    public IReadOnlyList<string> Images => _images;

    /// <summary>Opens a dataset.</summary>
    /// <param name="folder">A folder with the tables, or one with a folder such as v1.0-mini that has them.</param>
    /// <exception cref="DirectoryNotFoundException">There is no such folder.</exception>
    /// <exception cref="DatasetFormatException">A table is missing.</exception>
    public static ComparedNuScenes Open(string folder)
    {
        if (!Directory.Exists(folder))
        {
            throw new DirectoryNotFoundException($"Folder not found: '{folder}'.");
        }

        string[] candidates = [folder, .. Directory.EnumerateDirectories(folder, "v1.0*").Order(StringComparer.Ordinal)];
        string? tables = Array.Find(candidates, candidate => File.Exists(Path.Combine(candidate, "sample_annotation.json")));
        if (tables is null)
        {
            throw new DatasetFormatException($"'{folder}' has no tables of nuScenes (sample_annotation.json).");
        }

        string? missing = Array.Find(Tables, table => !File.Exists(Path.Combine(tables, table + ".json")));
        return missing is null
            ? new ComparedNuScenes(tables == folder ? Path.Combine(folder, "..") : folder, tables)
            : throw new DatasetFormatException($"'{tables}' lacks the table {missing}.json.");
    }

    /// <inheritdoc />
    public DatasetProfile Read(Action<int> report, CancellationToken cancellation)
    {
        _report = report;
        var profile = new DatasetProfile(Path.GetFileName(Path.TrimEndingDirectorySeparator(Path.GetFullPath(_folder))));
        Dictionary<string, string> names = Named("category", "token", "name", cancellation);
        Dictionary<string, string> kinds = Named("instance", "token", "category_token", cancellation);
        Dictionary<string, List<int>> viewsOfSamples = [];
        NuScenesView[] views = ReadViews(viewsOfSamples, cancellation);
        int[] objects = new int[views.Length];
        foreach (
            (string instance, string sample, string level, RigidFrame box, double[] size) in Records(
                "sample_annotation",
                item =>
                    (
                        item.Text("instance_token"),
                        item.Text("sample_token"),
                        item.OptionalText("visibility_token") ?? "",
                        FrameOf(item),
                        item.Numbers("size", VectorNumbers)
                    ),
                cancellation
            )
        )
        {
            string kind = Find(names, Find(kinds, instance, "instance"), "category");
            foreach (int view in viewsOfSamples.GetValueOrDefault(sample, []))
            {
                if (views[view].See(kind, ClassScheme.LevelOfNuScenes(level), box, size) is { } seen)
                {
                    profile.Add(seen);
                    objects[view]++;
                }
            }
        }

        foreach (int count in objects)
        {
            profile.AddFrame(count);
        }

        return profile;
    }

    /// <summary>The cameras of the key frames, and which belong to each sample.</summary>
    private NuScenesView[] ReadViews(Dictionary<string, List<int>> viewsOfSamples, CancellationToken cancellation)
    {
        HashSet<string> cameras =
        [
            .. Records("sensor", item => (Token: item.Text("token"), Kind: item.Text("modality")), cancellation)
                .Where(sensor => sensor.Kind == "camera")
                .Select(sensor => sensor.Token),
        ];
        var mounts = new Dictionary<string, (RigidFrame Frame, double[][] Intrinsics)>(StringComparer.Ordinal);
        foreach (
            (string token, string sensor, RigidFrame frame, double[][] intrinsics) in Records(
                "calibrated_sensor",
                item => (item.Text("token"), item.Text("sensor_token"), FrameOf(item), item.Rows("camera_intrinsic")),
                cancellation
            )
        )
        {
            if (cameras.Contains(sensor))
            {
                mounts[token] = (frame, intrinsics);
                CheckCount(mounts.Count, "calibrated_sensor");
            }
        }

        (Shot[] shots, string[] files) = ReadShots(viewsOfSamples, mounts.ContainsKey, cancellation);
        _images.AddRange(
            EvenSelection
                .Of(files.Length, ImageBrightness.MaxImages)
                .Select(index => files[index])
                .Where(file => InnerPath.IsWithin(_folder, file))
                .Select(file => InnerPath.Of(_folder, file))
                .Where(File.Exists)
        );
        HashSet<string> wanted = [.. shots.Select(shot => shot.Pose)];
        var poses = new Dictionary<string, RigidFrame>(StringComparer.Ordinal);
        foreach ((string token, RigidFrame frame) in Records("ego_pose", item => (item.Text("token"), FrameOf(item)), cancellation))
        {
            if (wanted.Contains(token))
            {
                poses[token] = frame;
            }
        }

        return [.. shots.Select(shot => ViewOf(Find(poses, shot.Pose, "ego_pose"), mounts[shot.Mount], shot.Width, shot.Height))];
    }

    /// <summary>The images of the key frames, in the order of their table.</summary>
    private (Shot[] Shots, string[] Files) ReadShots(
        Dictionary<string, List<int>> viewsOfSamples,
        Func<string, bool> isCamera,
        CancellationToken cancellation
    )
    {
        var shots = new List<Shot>();
        var files = new List<string>();
        foreach (
            (bool isKey, string sample, Shot shot, string file) in Records(
                "sample_data",
                item => (item.Boolean("is_key_frame"), item.Text("sample_token"), ShotOf(item), item.Text("filename")),
                cancellation
            )
        )
        {
            if (isKey && isCamera(shot.Mount))
            {
                viewsOfSamples.TryAdd(sample, []);
                viewsOfSamples[sample].Add(shots.Count);
                shots.Add(shot);
                files.Add(file);
                CheckCount(files.Count, "sample_data");
            }
        }

        return ([.. shots], [.. files]);
    }

    private static Shot ShotOf(JsonFields item) =>
        new(
            item.Text("ego_pose_token"),
            item.Text("calibrated_sensor_token"),
            (int)(item.OptionalNumber("width") ?? 0),
            (int)(item.OptionalNumber("height") ?? 0)
        );

    private NuScenesView ViewOf(RigidFrame pose, (RigidFrame Frame, double[][] Intrinsics) mount, int width, int height) =>
        mount.Intrinsics is [[var fx, _, var cx], [_, var fy, var cy], _]
            ? new NuScenesView(pose, mount.Frame, fx, fy, cx, cy, width, height)
            : throw new DatasetFormatException($"'{PathOf("calibrated_sensor")}': camera_intrinsic of a camera is not 3 x 3.");

    private Dictionary<string, string> Named(string table, string key, string value, CancellationToken cancellation)
    {
        var named = new Dictionary<string, string>(StringComparer.Ordinal);
        foreach ((string name, string text) in Records(table, item => (item.Text(key), item.Text(value)), cancellation))
        {
            named[name] = text;
            CheckCount(named.Count, table);
        }

        return named;
    }

    private void CheckCount(int count, string table)
    {
        if (count > MaxRecords)
        {
            throw new DatasetFormatException($"'{PathOf(table)}' has more than {MaxRecords} records to hold, the limit.");
        }
    }

    private T Find<T>(Dictionary<string, T> records, string token, string table) =>
        records.TryGetValue(token, out T? found)
            ? found
            : throw new DatasetFormatException($"'{PathOf(table)}' lacks the record '{token}' that another table names.");

    private static RigidFrame FrameOf(JsonFields item)
    {
        Vector3D origin = item.Vector("translation");
        double[] quaternion = item.Numbers("rotation", QuaternionNumbers);
        return item.Checked(() => new RigidFrame(origin, quaternion));
    }

    private string PathOf(string table) => Path.Combine(_tables, table + ".json");

    /// <summary>The records of a table, one by one.</summary>
    private IEnumerable<T> Records<T>(string table, Func<JsonFields, T> parse, CancellationToken cancellation)
    {
        using var reader = new JsonListReader(PathOf(table), isBare: true);
        while (TryRead(reader, table, parse, out T record))
        {
            cancellation.ThrowIfCancellationRequested();
            yield return record;
            _report(Math.Min(Length, (int)((_bytesBefore + reader.Position) / BytesPerUnit)));
        }

        _bytesBefore += reader.Length;
    }

    private bool TryRead<T>(JsonListReader reader, string table, Func<JsonFields, T> parse, out T record)
    {
        record = default!;
        try
        {
            if (!reader.Read())
            {
                return reader.HasList ? false : throw new DatasetFormatException("it is not a JSON list.");
            }

            record = parse(new JsonFields(reader.Element));
            return true;
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException($"'{PathOf(table)}': {JsonFault.InText(e)}", e);
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"'{PathOf(table)}', line {reader.Line}: {e.Message}", e);
        }
    }

    private readonly record struct Shot(string Pose, string Mount, int Width, int Height);
}
