using System.Text.Json;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Datasets.Logs;

/// <summary>The file traffic.json: what moved in a log, and its lights, by step (docs/logs.md).</summary>
internal static class TrafficFile
{
    /// <summary>Name of the file in its folder.</summary>
    public const string Name = "traffic.json";

    /// <summary>Name of the file of roads beside it.</summary>
    public const string Roads = "roads.csv";

    private const string Format = "gtaharvest traffic";
    private const int Version = 1;
    private const int Seconds = 4;
    private const int Metres = 4;
    private const int Radians = 6;

    /// <summary>Largest file, bytes, and what it may have.</summary>
    private const int MaxBytes = 32 << 20;
    private const int MaxSteps = 12_000;
    private const int MaxStates = 2_000_000;
    private const double MaxMetres = 1e6;
    private const double MaxSide = 100;
    private const double MaxSpeed = 200;

    /// <summary>Writes a log; its map is left out.</summary>
    /// <param name="stream">Where to.</param>
    /// <param name="log">The log.</param>
    /// <param name="source">Name of the file from which it comes.</param>
    public static void Write(Stream stream, MotionLog log, string source)
    {
        using var json = new Utf8JsonWriter(stream);
        json.WriteStartObject();
        json.WriteString("format", Format);
        json.WriteNumber("version", Version);
        json.WriteString("id", log.Id);
        json.WriteString("source", source);
        json.Numbers("times", [.. log.Times], Seconds);
        json.WriteNumber("ego", log.Tracks[log.Ego].Id);
        json.WriteStartArray("tracks");
        foreach (LogTrack track in log.Tracks)
        {
            WriteTrack(json, track);
        }

        json.WriteEndArray();
        json.WriteStartArray("lights");
        foreach (
            IGrouping<long, (LogSignal Signal, int Step)> lane in log
                .Signals.SelectMany((signals, step) => signals.Select(signal => (Signal: signal, Step: step)))
                .GroupBy(signal => signal.Signal.Lane)
                .OrderBy(lane => lane.Key)
        )
        {
            WriteLight(json, lane.Key, [.. lane], log.Times.Count);
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    /// <summary>Reads a file.</summary>
    /// <exception cref="DatasetFormatException">The file is invalid; the message begins with its path.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static MotionLog Read(string path)
    {
        try
        {
            using JsonDocument document = JsonInput.Parse(InputFile.ReadAllBytes(path, MaxBytes));
            return LogOf(new JsonFields(document.RootElement));
        }
        catch (Exception e) when (e is JsonException or DatasetFormatException)
        {
            throw new DatasetFormatException($"{path}: {JsonFault.InText(e)}", e);
        }
    }

    private static void WriteTrack(Utf8JsonWriter json, LogTrack track)
    {
        int first = track.States.Index().First(state => state.Item is not null).Index;
        int last = track.States.Index().Last(state => state.Item is not null).Index;
        json.WriteStartObject();
        json.WriteNumber("id", track.Id);
        json.WriteString("kind", NameOf(track.Kind));
        json.WriteNumber("firstStep", first);
        json.WriteStartArray("states");
        for (int step = first; step <= last; step++)
        {
            if (track.States[step] is { } state)
            {
                json.WriteStartArray();
                json.Value(state.Centre.X, Metres);
                json.Value(state.Centre.Y, Metres);
                json.Value(state.Centre.Z, Metres);
                json.Value(state.Length, Metres);
                json.Value(state.Width, Metres);
                json.Value(state.Height, Metres);
                json.Value(state.Heading, Radians);
                json.Value(state.Velocity.X, Metres);
                json.Value(state.Velocity.Y, Metres);
                json.WriteEndArray();
            }
            else
            {
                json.WriteNullValue();
            }
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void WriteLight(Utf8JsonWriter json, long lane, (LogSignal Signal, int Step)[] signals, int steps)
    {
        var states = new int[steps];
        foreach ((LogSignal signal, int step) in signals)
        {
            states[step] = (int)signal.Light;
        }

        Vector3D stop = signals[0].Signal.Stop;
        json.WriteStartObject();
        json.WriteNumber("lane", lane);
        json.Numbers("stop", [stop.X, stop.Y, stop.Z], Metres);
        json.Numbers("states", [.. states.Select(state => (double)state)], 0);
        json.WriteEndObject();
    }

    private static MotionLog LogOf(JsonFields file)
    {
        if (file.OptionalText("format") != Format || file.Integer("version") != Version)
        {
            throw new DatasetFormatException($"it is no file of traffic of version {Version}, which 'harvester log import' writes.");
        }

        double[] times = file.Numbers("times");
        Require(times.Length is > 0 and <= MaxSteps, FormattableString.Invariant($"times has {times.Length} steps, not 1 to {MaxSteps}."));
        Require(
            times.Zip(times.Skip(1)).All(pair => pair.Second > pair.First) && times.All(time => Math.Abs(time) <= MaxMetres),
            "times do not rise."
        );
        IReadOnlyList<JsonFields> listed = file.List("tracks");
        Require(
            (long)listed.Count * times.Length <= MaxStates,
            FormattableString.Invariant($"it has more than {MaxStates} states of tracks, the limit.")
        );
        LogTrack[] tracks = [.. listed.Select(track => TrackOf(track, times.Length))];
        Require(tracks.Select(track => track.Id).Distinct().Count() == tracks.Length, "two tracks have the same id.");
        int ego = file.Integer("ego");
        int index = Array.FindIndex(tracks, track => track.Id == ego);
        Require(
            index >= 0 && tracks[index].Kind == TrafficLogKind.Vehicle,
            FormattableString.Invariant($"ego is {ego}, which is no vehicle of tracks.")
        );
        List<LogSignal>[] signals = [.. times.Select(_ => new List<LogSignal>())];
        foreach (JsonFields light in file.List("lights"))
        {
            AddLight(signals, light);
        }

        return new MotionLog(file.Text("id"), times, tracks, index, [], signals);
    }

    private static LogTrack TrackOf(JsonFields track, int steps)
    {
        int first = track.Integer("firstStep");
        var states = new LogState?[steps];
        double[]?[] rows = RowsOf(track);
        Require(
            first >= 0 && rows.Length > 0 && first <= steps - rows.Length,
            "a track has states before the first or after the last of times, or none."
        );
        for (int i = 0; i < rows.Length; i++)
        {
            states[first + i] = rows[i] is { } row ? StateOf(row) : null;
        }

        Require(Array.Exists(states, state => state is not null), "a track has no state.");
        return new LogTrack(
            track.Integer("id"),
            Enum.GetValues<TrafficLogKind>().Where(kind => NameOf(kind) == track.Text("kind")).Cast<TrafficLogKind?>().FirstOrDefault()
                ?? throw new DatasetFormatException("the kind of a track is not vehicle, pedestrian or cyclist."),
            states
        );
    }

    private static double[]?[] RowsOf(JsonFields track)
    {
        using JsonDocument document = JsonDocument.Parse(track.RawText("states"));
        JsonElement list = document.RootElement;
        Require(list.ValueKind == JsonValueKind.Array, "states of a track is no list.");
        return [.. list.EnumerateArray().Select(RowOf)];
    }

    private static double[]? RowOf(JsonElement row)
    {
        const int columns = 9;
        if (row.ValueKind == JsonValueKind.Null)
        {
            return null;
        }

        Require(
            row.ValueKind == JsonValueKind.Array
                && row.GetArrayLength() == columns
                && row.EnumerateArray().All(item => item.ValueKind == JsonValueKind.Number),
            "a state of a track is not a list of 9 numbers."
        );
        return [.. row.EnumerateArray().Select(item => item.TryGetDouble(out double value) ? value : double.NaN)];
    }

    private static LogState StateOf(double[] row)
    {
        Require(
            row.All(double.IsFinite)
                && row.Take(3).All(value => Math.Abs(value) <= MaxMetres)
                && row.Skip(3).Take(3).All(side => side is > 0 and <= MaxSide)
                && Math.Abs(row[6]) <= 2 * Math.PI
                && row.Skip(7).All(value => Math.Abs(value) <= MaxSpeed),
            "a state of a track has a place, size, heading or velocity beyond the limits of docs/logs.md."
        );
        return new LogState(new Vector3D(row[0], row[1], row[2]), row[3], row[4], row[5], row[6], new Vector2D(row[7], row[8]));
    }

    private static void AddLight(List<LogSignal>[] signals, JsonFields light)
    {
        double[] stop = light.Numbers("stop", 3);
        double[] states = light.Numbers("states");
        Require(states.Length == signals.Length, "a light has not as many states as there are times.");
        Require(stop.All(value => Math.Abs(value) <= MaxMetres), "the stop of a light is too far away.");
        long lane = light.LongInteger("lane");
        for (int step = 0; step < states.Length; step++)
        {
            Require(states[step] is >= 0 and <= (int)LogLight.FlashingCaution && states[step] % 1 == 0, "a light has an unknown state.");
            signals[step].Add(new LogSignal(lane, (LogLight)(int)states[step], new Vector3D(stop[0], stop[1], stop[2])));
        }
    }

    private static string NameOf(TrafficLogKind kind) =>
        kind switch
        {
            TrafficLogKind.Pedestrian => "pedestrian",
            TrafficLogKind.Cyclist => "cyclist",
            _ => "vehicle",
        };

    private static void Require(bool isTrue, string problem)
    {
        if (!isTrue)
        {
            throw new DatasetFormatException(problem);
        }
    }
}
