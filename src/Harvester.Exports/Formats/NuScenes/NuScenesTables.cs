using System.Text.Json;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>The thirteen tables of nuScenes. Each record is an action that writes its fields.</summary>
internal static class NuScenesTables
{
    private const string Date = "2020-01-01";

    /// <summary>Makes the records of each table from the scenes.</summary>
    public static IReadOnlyDictionary<string, Func<IEnumerable<NuScenesScene>, IEnumerable<Action<Utf8JsonWriter>>>> All { get; } =
        new SortedDictionary<string, Func<IEnumerable<NuScenesScene>, IEnumerable<Action<Utf8JsonWriter>>>>(StringComparer.Ordinal)
        {
            ["attribute"] = _ => NuScenesClasses.Attributes.Select(name => Named(AttributeToken(name), name)),
            ["calibrated_sensor"] = Calibrations,
            ["category"] = _ => NuScenesClasses.Categories.Select(name => Named(CategoryToken(name), name)),
            ["ego_pose"] = scenes => scenes.SelectMany(NuScenesDataTables.Poses),
            ["instance"] = scenes => scenes.SelectMany(NuScenesObjectTables.Instances),
            ["log"] = Logs,
            ["map"] = Maps,
            ["sample"] = scenes => scenes.SelectMany(NuScenesDataTables.Samples),
            ["sample_annotation"] = scenes => scenes.SelectMany(NuScenesObjectTables.Annotations),
            ["sample_data"] = scenes => scenes.SelectMany(NuScenesDataTables.Data),
            ["scene"] = scenes => scenes.Select(Scene),
            ["sensor"] = Sensors,
            ["visibility"] = _ => NuScenesClasses.Visibilities.Select((visibility, index) => Visibility(index + 1, visibility.Level)),
        };

    /// <summary>The token of a category.</summary>
    public static string CategoryToken(string name) => NuScenesToken.Of("category", name);

    /// <summary>The token of an attribute.</summary>
    public static string AttributeToken(string name) => NuScenesToken.Of("attribute", name);

    /// <summary>Writes a table: a record per line.</summary>
    public static void Write(TextWriter writer, IEnumerable<Action<Utf8JsonWriter>> records) =>
        WriteList(
            writer,
            records.Select(record =>
                (Action<Utf8JsonWriter>)(
                    json =>
                    {
                        json.WriteStartObject();
                        record(json);
                        json.WriteEndObject();
                    }
                )
            )
        );

    /// <summary>Writes a list: a value per line.</summary>
    public static void WriteList(TextWriter writer, IEnumerable<Action<Utf8JsonWriter>> values)
    {
        string before = "[\n";
        foreach (Action<Utf8JsonWriter> value in values)
        {
            writer.Write(before);
            writer.Write(JsonLine.Of(value));
            before = ",\n";
        }

        writer.Write(before == "[\n" ? "[]\n" : "\n]\n");
    }

    /// <summary>Writes splits.json: the scenes of each split, under names that no official split has.</summary>
    public static void WriteSplits(TextWriter writer, IEnumerable<string> lines)
    {
        var splits = new SortedDictionary<string, List<string>>(StringComparer.Ordinal);
        foreach (NuScenesScene scene in NuScenesScene.All(lines).Where(scene => scene.Keys.Count > 0))
        {
            string name = SplitOf(scene.Frames[0].Split);
            splits.TryAdd(name, []);
            splits[name].Add(scene.Name);
        }

        writer.Write(
            JsonLine.Of(json =>
            {
                json.WriteStartObject();
                foreach ((string name, List<string> scenes) in splits)
                {
                    json.WriteStartArray(name);
                    scenes.ForEach(json.WriteStringValue);
                    json.WriteEndArray();
                }

                json.WriteEndObject();
            }) + "\n"
        );
    }

    /// <summary>The name of a split in splits.json.</summary>
    public static string SplitOf(string split) => $"gta_{split}";

    /// <summary>Writes the link from a record to another one; an empty text at the ends of a chain.</summary>
    public static void Link(this Utf8JsonWriter json, string name, string? token) => json.WriteString(name, token ?? "");

    private static Action<Utf8JsonWriter> Named(string token, string name) =>
        json =>
        {
            json.WriteString("token", token);
            json.WriteString("name", name);
            json.WriteString("description", "");
        };

    private static Action<Utf8JsonWriter> Visibility(int token, string level) =>
        json =>
        {
            json.WriteString("token", Numbers.Text(token));
            json.WriteString("level", level);
            json.WriteString("description", "");
        };

    private static Action<Utf8JsonWriter> Scene(NuScenesScene scene) =>
        json =>
        {
            json.WriteString("token", scene.Token);
            json.WriteString("log_token", scene.LogToken);
            json.WriteNumber("nbr_samples", scene.Keys.Count);
            json.Link("first_sample_token", scene.SampleTokenOf(scene.Keys[0]));
            json.Link("last_sample_token", scene.SampleTokenOf(scene.Keys[^1]));
            json.WriteString("name", scene.Name);
            json.WriteString("description", scene.Frames[0].Description);
        };

    private static IEnumerable<Action<Utf8JsonWriter>> Logs(IEnumerable<NuScenesScene> scenes) =>
        scenes.Select(scene =>
            (Action<Utf8JsonWriter>)(
                json =>
                {
                    string log = NuScenesWriter.LogOf(scene.Recording, scene.Frames[0].Place);
                    json.WriteString("token", scene.LogToken);
                    json.WriteString("logfile", log);
                    json.WriteString("vehicle", "gta");
                    json.WriteString("date_captured", Date);
                    json.WriteString("location", log);
                }
            )
        );

    private static IEnumerable<Action<Utf8JsonWriter>> Maps(IEnumerable<NuScenesScene> scenes) =>
        scenes.Select(scene =>
            (Action<Utf8JsonWriter>)(
                json =>
                {
                    json.WriteString("token", NuScenesToken.Of("map", scene.Number));
                    json.WriteString("category", "semantic_prior");
                    json.WriteString("filename", NuScenesMap.PathOf(scene.Name));
                    json.WriteStartArray("log_tokens");
                    json.WriteStringValue(scene.LogToken);
                    json.WriteEndArray();
                }
            )
        );

    private static IEnumerable<Action<Utf8JsonWriter>> Sensors(IEnumerable<NuScenesScene> scenes) =>
        scenes
            .SelectMany(scene => scene.Frames)
            .SelectMany(frame => frame.Sensors)
            .Select(sensor => (sensor.Channel, sensor.IsCamera))
            .Distinct()
            .Select(sensor =>
                (Action<Utf8JsonWriter>)(
                    json =>
                    {
                        json.WriteString("token", SensorToken(sensor.Channel));
                        json.WriteString("channel", sensor.Channel);
                        json.WriteString("modality", sensor.IsCamera ? "camera" : "lidar");
                    }
                )
            );

    private static IEnumerable<Action<Utf8JsonWriter>> Calibrations(IEnumerable<NuScenesScene> scenes)
    {
        var written = new HashSet<string>(StringComparer.Ordinal);
        foreach (NuScenesScene scene in scenes)
        {
            foreach (NuScenesSensor sensor in scene.Frames.SelectMany(frame => frame.Sensors))
            {
                string token = scene.CalibrationTokenOf(sensor.Channel);
                if (written.Add(token))
                {
                    yield return json =>
                    {
                        json.WriteString("token", token);
                        json.WriteString("sensor_token", SensorToken(sensor.Channel));
                        NuScenesDataTables.WriteFields(json, sensor.Calibration);
                    };
                }
            }
        }
    }

    private static string SensorToken(string channel) => NuScenesToken.Of("sensor", channel);
}
