using System.Text.Json;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>The thirteen tables of nuScenes. Each record is an action that writes its fields.</summary>
internal static class NuScenesTables
{
    private const string Date = "2020-01-01";

    /// <summary>Those of the format; the files after them are about splits and maps.</summary>
    private const int TableCount = 13;

    /// <summary>Names of the tables.</summary>
    public static IReadOnlyList<string> Names { get; } = [.. Create().Take(TableCount).Select(table => table.Name)];

    /// <summary>The tables, the splits and the places of the maps, of the parts of a name.</summary>
    public static AggregateTables Of(string part) =>
        new(part, [.. Create().Select(table => $"{NuScenesWriter.Version}/{table.Name}.json")], Write);

    /// <summary>The token of a category.</summary>
    public static string CategoryToken(string name) => NuScenesToken.Of("category", name);

    /// <summary>The token of an attribute.</summary>
    public static string AttributeToken(string name) => NuScenesToken.Of("attribute", name);

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

    /// <summary>Writes the link from a record to another one; an empty text at the ends of a chain.</summary>
    public static void Link(this Utf8JsonWriter json, string name, string? token) => json.WriteString(name, token ?? "");

    private static NuScenesTable[] Create()
    {
        var calibrated = new HashSet<string>(StringComparer.Ordinal);
        var sensors = new HashSet<string>(StringComparer.Ordinal);
        var happened = new HashSet<string>(StringComparer.Ordinal);
        return
        [
            new NuScenesRecords(
                "attribute",
                scene => EventAttributes(scene, happened),
                NuScenesClasses.Attributes.Select(name => Named(AttributeToken(name), name))
            ),
            new NuScenesRecords("calibrated_sensor", scene => Calibrations(scene, calibrated)),
            new NuScenesRecords("category", None, NuScenesClasses.Categories.Select(each => Category(each.Name, each.Index))),
            new NuScenesRecords("ego_pose", NuScenesDataTables.Poses),
            new NuScenesRecords("instance", NuScenesObjectTables.Instances),
            new NuScenesRecords("log", scene => [Log(scene)]),
            new NuScenesRecords("map", scene => [Map(scene)]),
            new NuScenesRecords("sample", NuScenesDataTables.Samples),
            new NuScenesRecords("sample_annotation", NuScenesObjectTables.Annotations),
            new NuScenesRecords("sample_data", NuScenesDataTables.Data),
            new NuScenesRecords("scene", scene => [Scene(scene)]),
            new NuScenesRecords("sensor", scene => Sensors(scene, sensors)),
            new NuScenesRecords(
                "visibility",
                None,
                NuScenesClasses.Visibilities.Select((visibility, index) => Visibility(index + 1, visibility.Level))
            ),
            new NuScenesSplits(),
            new NuScenesRecords(NuScenesMapOffsets.Name, scene => [NuScenesMapOffsets.Of(scene)]),
        ];
    }

    private static void Write(IReadOnlyList<TextWriter> writers, IEnumerable<string> parts)
    {
        NuScenesTable[] tables = Create();
        foreach (NuScenesScene scene in NuScenesScene.All(parts))
        {
            foreach ((NuScenesTable table, TextWriter writer) in tables.Zip(writers))
            {
                table.Add(writer, scene);
            }
        }

        foreach ((NuScenesTable table, TextWriter writer) in tables.Zip(writers))
        {
            table.End(writer);
        }
    }

    private static IEnumerable<Action<Utf8JsonWriter>> EventAttributes(NuScenesScene scene, HashSet<string> written) =>
        scene
            .Keys.SelectMany(moment => scene.EventsOf(moment) ?? [])
            .Select(each => each.Attribute)
            .Where(written.Add)
            .Select(name => Named(AttributeToken(name), name));

    private static IEnumerable<Action<Utf8JsonWriter>> None(NuScenesScene scene) => [];

    private static Action<Utf8JsonWriter> Named(string token, string name) =>
        json =>
        {
            json.WriteString("token", token);
            json.WriteString("name", name);
            json.WriteString("description", "");
        };

    private static Action<Utf8JsonWriter> Category(string name, int index) =>
        json =>
        {
            Named(CategoryToken(name), name)(json);
            json.WriteNumber("index", index);
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

    private static Action<Utf8JsonWriter> Log(NuScenesScene scene) =>
        json =>
        {
            string log = NuScenesWriter.LogOf(scene.Recording, scene.Frames[0].Place);
            json.WriteString("token", scene.LogToken);
            json.WriteString("logfile", log);
            json.WriteString("vehicle", "gta");
            json.WriteString("date_captured", Date);
            json.WriteString("location", NuScenesExpansions.LocationOf(scene.Number, scene.Frames[0].HasLanes, log));
        };

    private static Action<Utf8JsonWriter> Map(NuScenesScene scene) =>
        json =>
        {
            json.WriteString("token", NuScenesToken.Of("map", scene.Number));
            json.WriteString("category", "semantic_prior");
            json.WriteString("filename", NuScenesMap.PathOf(scene.Name));
            json.WriteStartArray("log_tokens");
            json.WriteStringValue(scene.LogToken);
            json.WriteEndArray();
        };

    private static IEnumerable<Action<Utf8JsonWriter>> Sensors(NuScenesScene scene, HashSet<string> written)
    {
        foreach (NuScenesSensor sensor in scene.Frames.SelectMany(frame => frame.Sensors))
        {
            if (written.Add(sensor.Channel))
            {
                yield return json =>
                {
                    json.WriteString("token", SensorToken(sensor.Channel));
                    json.WriteString("channel", sensor.Channel);
                    json.WriteString("modality", sensor.Modality);
                };
            }
        }
    }

    private static IEnumerable<Action<Utf8JsonWriter>> Calibrations(NuScenesScene scene, HashSet<string> written)
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

    private static string SensorToken(string channel) => NuScenesToken.Of("sensor", channel);
}
