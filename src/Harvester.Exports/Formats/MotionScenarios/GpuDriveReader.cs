using System.Globalization;
using System.Text.Json;
using Harvester.Datasets.Logs;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>Reads a scenario from GPUDrive's JSON.</summary>
internal static class GpuDriveReader
{
    /// <summary>Reads a file.</summary>
    /// <exception cref="DatasetFormatException">The file is not such a scenario, or too large; the message refers to it as
    /// "it".</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static LogReading Read(string path)
    {
        try
        {
            using JsonDocument document = JsonInput.Parse(InputFile.ReadAllBytes(path, LogLimits.JsonBytes));
            return Of(new JsonFields(document.RootElement), document.RootElement);
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException(JsonFault.InText(e), e);
        }
    }

    /// <summary>The scenario of a file, read when it is asked for.</summary>
    /// <exception cref="DatasetFormatException">As for <see cref="Read"/>.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static IEnumerable<LogReading> ReadAll(string path)
    {
        yield return Read(path);
    }

    private static LogReading Of(JsonFields fields, JsonElement root)
    {
        var draft = new LogDraft();
        string id = fields.OptionalText("scenario_id") ?? fields.Text("name");
        int? steps = null;
        foreach (JsonElement item in ListOf(root, "objects"))
        {
            LogState?[] states = StatesOf(item);
            LogLimits.Require(states.Length == (steps ??= states.Length), "its objects have different numbers of steps.");
            bool isKnown = GpuDriveNames.Kinds.TryGetValue(TextOf(item, "type"), out TrafficLogKind kind);
            draft.Add(IntegerOf(item, "id"), isKnown ? kind : null, states);
        }

        foreach (JsonElement item in ListOf(root, "roads"))
        {
            AddFeature(draft, item);
        }

        int count = steps ?? 0;
        for (int step = 0; step < Math.Min(count, LogLimits.Steps); step++)
        {
            draft.Signals.Add([]);
        }

        if (fields.Has("tl_states"))
        {
            JsonElement lights = root.GetProperty("tl_states");
            LogLimits.Require(lights.ValueKind == JsonValueKind.Object, "'tl_states' is no object.");
            foreach (JsonProperty lane in lights.EnumerateObject())
            {
                AddSignals(draft, lane);
            }
        }

        return draft.Finish(
            id,
            [.. Enumerable.Range(0, count).Select(step => Math.Round(step * ScenarioWindow.Step, 1))],
            fields.Fields("metadata").Integer("sdc_track_index")
        );
    }

    private static LogState?[] StatesOf(JsonElement item)
    {
        JsonElement[] positions = [.. ListOf(item, "position")];
        JsonElement[] headings = [.. ListOf(item, "heading")];
        JsonElement[] velocities = [.. ListOf(item, "velocity")];
        JsonElement[] valid = [.. ListOf(item, "valid")];
        LogLimits.Require(
            positions.Length == headings.Length && positions.Length == velocities.Length && positions.Length == valid.Length,
            "the lists of an object have different lengths."
        );
        LogLimits.Require(
            positions.Length <= LogLimits.Steps,
            FormattableString.Invariant($"an object has more than {LogLimits.Steps} steps, the limit.")
        );
        (double, double, double) size = (NumberOf(item, "length"), NumberOf(item, "width"), NumberOf(item, "height"));
        return
        [
            .. Enumerable
                .Range(0, positions.Length)
                .Select<int, LogState?>(step =>
                    IsTrue(valid[step])
                        ? LogDraft.State(
                            PointOf(positions[step]),
                            size,
                            NumberOf(headings[step], "heading"),
                            new Vector2D(NumberOf(velocities[step], "x", "velocity"), NumberOf(velocities[step], "y", "velocity"))
                        )
                        : null
                ),
        ];
    }

    private static void AddFeature(LogDraft draft, JsonElement item)
    {
        if (!GpuDriveNames.Features.TryGetValue(TextOf(item, "type"), out LogFeatureKind kind))
        {
            draft.LeaveOut("parts of the map of other kinds");
            return;
        }

        Vector3D[] points = [.. ListOf(item, "geometry").Select(PointOf)];
        if (points.Length < (kind == LogFeatureKind.StopSign ? 1 : 2))
        {
            draft.LeaveOut("parts of the map with too few points");
            return;
        }

        int element = item.TryGetProperty("map_element_id", out _) ? IntegerOf(item, "map_element_id") : 0;
        draft.Add(new LogFeature(IntegerOf(item, "id"), kind, GpuDriveNames.TypeOf(kind, element), points));
    }

    private static void AddSignals(LogDraft draft, JsonProperty lane)
    {
        if (!long.TryParse(lane.Name, NumberStyles.None, CultureInfo.InvariantCulture, out long id))
        {
            throw new DatasetFormatException("tl_states has a lane whose name is no number.");
        }

        JsonElement[] states = [.. ListOf(lane.Value, "state")];
        JsonElement[] x = [.. ListOf(lane.Value, "x")];
        JsonElement[] y = [.. ListOf(lane.Value, "y")];
        JsonElement[] z = [.. ListOf(lane.Value, "z")];
        JsonElement[] steps = [.. ListOf(lane.Value, "time_index")];
        LogLimits.Require(
            new[] { x.Length, y.Length, z.Length, steps.Length }.All(length => length == states.Length),
            "the lists of a lane in tl_states have different lengths."
        );
        for (int i = 0; i < states.Length; i++)
        {
            string word = states[i].ValueKind == JsonValueKind.String ? states[i].GetString()! : "";
            int light = GpuDriveNames.Lights.ToList().IndexOf(word);
            LogLimits.Require(light >= 0, "tl_states has an unknown state of a light.");
            LogLimits.Require(
                steps[i].ValueKind == JsonValueKind.Number && steps[i].TryGetInt32(out int step) && step >= 0 && step < draft.Signals.Count,
                "tl_states has a time_index that is no step."
            );
            List<LogSignal> signals = draft.Signals[steps[i].GetInt32()];
            LogLimits.Require(signals.Count < LogLimits.Features, "tl_states has too many lanes.");
            signals.Add(new LogSignal(id, (LogLight)light, LogDraft.Point(NumberOf(x[i], "x"), NumberOf(y[i], "y"), NumberOf(z[i], "z"))));
        }
    }

    private static JsonElement.ArrayEnumerator ListOf(JsonElement item, string name) =>
        item.ValueKind == JsonValueKind.Object && item.TryGetProperty(name, out JsonElement list) && list.ValueKind == JsonValueKind.Array
            ? list.EnumerateArray()
            : throw new DatasetFormatException($"'{name}' is missing or no list.");

    private static string TextOf(JsonElement item, string name) =>
        item.ValueKind == JsonValueKind.Object && item.TryGetProperty(name, out JsonElement text) && text.ValueKind == JsonValueKind.String
            ? text.GetString()!
            : throw new DatasetFormatException($"'{name}' is missing or no text.");

    private static int IntegerOf(JsonElement item, string name) =>
        item.ValueKind == JsonValueKind.Object
        && item.TryGetProperty(name, out JsonElement number)
        && number.ValueKind == JsonValueKind.Number
        && number.TryGetInt32(out int value)
            ? value
            : throw new DatasetFormatException($"'{name}' is missing or no whole number.");

    private static double NumberOf(JsonElement item, string name, string of) =>
        item.ValueKind == JsonValueKind.Object && item.TryGetProperty(name, out JsonElement number)
            ? NumberOf(number, name)
            : throw new DatasetFormatException($"'{name}' of a {of} is missing.");

    private static double NumberOf(JsonElement item, string name) =>
        item.ValueKind == JsonValueKind.Object ? NumberOf(item, name, "thing")
        : item.ValueKind == JsonValueKind.Number && item.TryGetDouble(out double value) ? value
        : throw new DatasetFormatException($"'{name}' is no number.");

    private static bool IsTrue(JsonElement item) =>
        item.ValueKind is JsonValueKind.True
        || (item.ValueKind is not JsonValueKind.False ? throw new DatasetFormatException("'valid' is neither true nor false.") : false);

    /// <summary>A point; files of its predecessor have no height.</summary>
    private static Vector3D PointOf(JsonElement item) =>
        LogDraft.Point(
            NumberOf(item, "x", "point"),
            NumberOf(item, "y", "point"),
            item.TryGetProperty("z", out JsonElement z) ? NumberOf(z, "z") : 0
        );
}
