using System.Globalization;
using System.Text.Json;
using Harvester.Datasets.Logs;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>Writes a scenario as GPUDrive's JSON.</summary>
internal static class GpuDriveScenario
{
    private const int Metres = 5;
    private const int Radians = 7;

    /// <summary>Writes a file.</summary>
    /// <param name="stream">Where to.</param>
    /// <param name="log">The scenario.</param>
    /// <param name="name">Name of the file.</param>
    /// <param name="measured">Whether a step is that of a frame.</param>
    public static void Write(Stream stream, MotionLog log, string name, IReadOnlyList<bool> measured)
    {
        using var json = new Utf8JsonWriter(stream);
        json.WriteStartObject();
        json.WriteString("name", name);
        json.WriteString("scenario_id", log.Id);
        json.WriteStartArray("objects");
        foreach (LogTrack track in log.Tracks)
        {
            WriteTrack(json, track);
        }

        json.WriteEndArray();
        json.WriteStartArray("roads");
        foreach (LogFeature feature in log.Features)
        {
            WriteFeature(json, feature);
        }

        json.WriteEndArray();
        WriteSignals(json, log);
        json.WriteStartObject("metadata");
        json.WriteNumber("sdc_track_index", log.Ego);
        json.WriteStartArray("objects_of_interest");
        json.WriteEndArray();
        json.WriteStartArray("tracks_to_predict");
        foreach (int index in PredictionTargets.Of(log))
        {
            json.WriteStartObject();
            json.WriteNumber("track_index", index);
            json.WriteNumber("difficulty", 0);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartArray("measured_steps");
        foreach (int step in Enumerable.Range(0, measured.Count).Where(step => measured[step]))
        {
            json.WriteNumberValue(step);
        }

        json.WriteEndArray();
        json.WriteEndObject();
        json.WriteEndObject();
    }

    private static void WriteTrack(Utf8JsonWriter json, LogTrack track)
    {
        json.WriteStartObject();
        json.WriteStartArray("position");
        foreach (LogState? state in track.States)
        {
            WritePoint(json, state?.Centre ?? new Vector3D(GpuDriveNames.Invalid, GpuDriveNames.Invalid, GpuDriveNames.Invalid));
        }

        json.WriteEndArray();

        // The format has one size of an object; as in its own files, that of the last state.
        LogState last = track.States.Last(state => state is not null)!.Value;
        json.Number("width", last.Width, Metres);
        json.Number("length", last.Length, Metres);
        json.Number("height", last.Height, Metres);
        json.Numbers("heading", [.. track.States.Select(state => state?.Heading ?? GpuDriveNames.Invalid)], Radians);
        json.WriteStartArray("velocity");
        foreach (LogState? state in track.States)
        {
            json.WriteStartObject();
            json.Number("x", state?.Velocity.X ?? GpuDriveNames.Invalid, Metres);
            json.Number("y", state?.Velocity.Y ?? GpuDriveNames.Invalid, Metres);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartArray("valid");
        foreach (LogState? state in track.States)
        {
            json.WriteBooleanValue(state is not null);
        }

        json.WriteEndArray();
        json.WritePropertyName("goalPosition");
        WritePoint(json, last.Centre);
        json.WriteString("type", GpuDriveNames.Kinds.First(kind => kind.Value == track.Kind).Key);
        json.WriteNumber("id", track.Id);
        json.WriteBoolean("mark_as_expert", false);
        json.WriteEndObject();
    }

    private static void WriteFeature(Utf8JsonWriter json, LogFeature feature)
    {
        json.WriteStartObject();
        json.WriteStartArray("geometry");
        foreach (Vector3D point in feature.Points)
        {
            WritePoint(json, point);
        }

        json.WriteEndArray();
        json.WriteString("type", GpuDriveNames.Features.First(kind => kind.Value == feature.Kind).Key);
        json.WriteNumber("map_element_id", GpuDriveNames.ElementOf(feature.Kind, feature.Type));
        json.WriteNumber("id", feature.Id);
        json.WriteEndObject();
    }

    private static void WriteSignals(Utf8JsonWriter json, MotionLog log)
    {
        json.WriteStartObject("tl_states");
        foreach (
            IGrouping<long, (LogSignal Signal, int Step)> lane in log
                .Signals.SelectMany((signals, step) => signals.Select(signal => (Signal: signal, Step: step)))
                .GroupBy(signal => signal.Signal.Lane)
                .OrderBy(lane => lane.Key)
        )
        {
            json.WriteStartObject(lane.Key.ToString(CultureInfo.InvariantCulture));
            json.WriteStartArray("state");
            foreach ((LogSignal signal, _) in lane)
            {
                json.WriteStringValue(GpuDriveNames.Lights[(int)signal.Light]);
            }

            json.WriteEndArray();
            json.Numbers("x", [.. lane.Select(signal => signal.Signal.Stop.X)], Metres);
            json.Numbers("y", [.. lane.Select(signal => signal.Signal.Stop.Y)], Metres);
            json.Numbers("z", [.. lane.Select(signal => signal.Signal.Stop.Z)], Metres);
            json.Numbers("time_index", [.. lane.Select(signal => (double)signal.Step)], 0);
            json.WriteEndObject();
        }

        json.WriteEndObject();
    }

    private static void WritePoint(Utf8JsonWriter json, Vector3D point)
    {
        json.WriteStartObject();
        json.Number("x", point.X, Metres);
        json.Number("y", point.Y, Metres);
        json.Number("z", point.Z, Metres);
        json.WriteEndObject();
    }
}
