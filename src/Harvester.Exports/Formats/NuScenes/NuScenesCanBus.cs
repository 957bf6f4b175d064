using System.Text.Json;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>
/// The messages of nuScenes' CAN bus expansion, one file for each kind and scene. Poses, velocities and controls are exact; what is
/// modelled or unknown is listed in docs/exports/nuscenes.md.
/// </summary>
internal static class NuScenesCanBus
{
    /// <summary>Folder of the messages.</summary>
    public const string Folder = "can_bus";

    private const string PartPrefix = "can ";
    private const string Meta = "meta";
    private const string Route = "route";
    private const double MonitorSeconds = 0.5;
    private const int Decimals = 6;
    private const int QuaternionDecimals = 9;

    /// <summary>The messages of each kind, from those of a scene.</summary>
    public static IReadOnlyDictionary<string, Func<NuScenesRide, IEnumerable<NuScenesMessage>>> Kinds { get; } =
        new SortedDictionary<string, Func<NuScenesRide, IEnumerable<NuScenesMessage>>>(StringComparer.Ordinal)
        {
            ["ms_imu"] = ride => ride.All.Select(NuScenesMessages.Imu),
            ["pose"] = ride => ride.All.Select(NuScenesMessages.Pose),
            ["steeranglefeedback"] = ride =>
                ride.All.Where(moment => moment.Reading.Controls is not null).Select(NuScenesMessages.SteeringFeedback),
            ["vehicle_monitor"] = ride => ride.Every(MonitorSeconds).Select(NuScenesMessages.VehicleMonitor),
            ["zoe_veh_info"] = ride => ride.All.Select(NuScenesMessages.VehicleInfo),
            ["zoesensors"] = ride => ride.All.Where(moment => moment.Reading.Controls is not null).Select(NuScenesMessages.Sensors),
        };

    /// <summary>The kinds of files of a scene.</summary>
    public static IEnumerable<string> FileKinds => Kinds.Keys.Append(Meta).Append(Route);

    /// <summary>Path of a file.</summary>
    /// <param name="scene">Number of the scene in the dataset, from 0.</param>
    /// <param name="kind">Kind of its messages.</param>
    public static string PathOf(int scene, string kind) => $"{Folder}/{NuScenesScene.NameOf(scene)}_{kind}.json";

    /// <summary>Adds the ego's motion up to a moment.</summary>
    /// <param name="output">Takes the part.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="area">The part of the world around it.</param>
    /// <param name="rows">A row for each tick; none except for the first view.</param>
    public static void Add(FrameOutput output, ExportFrame frame, NuScenesArea area, IEnumerable<string> rows) =>
        output.Part(
            FormattableString.Invariant($"{PartPrefix}{frame.RecordingIndex:D8} {frame.Label.Place ?? 0:D8}"),
            string.Join(NuScenesRide.Separator, rows.Prepend(area.ToString()))
        );

    /// <summary>The files of all scenes.</summary>
    /// <param name="parts">The names of all parts.</param>
    /// <param name="hasSample">Whether a session has a sample at a place; others are no scenes.</param>
    public static IEnumerable<AggregateFile> Files(IEnumerable<string> parts, Func<string, bool> hasSample) =>
        parts
            .Where(part => part.StartsWith(PartPrefix, StringComparison.Ordinal) && hasSample(part[PartPrefix.Length..]))
            .Order(StringComparer.Ordinal)
            .SelectMany(
                (part, scene) =>
                    FileKinds.Select(kind => new AggregateFile(
                        PathOf(scene, kind),
                        [AggregateSection.Summary(part, (writer, lines) => Write(writer, kind, NuScenesRide.Read(lines)))]
                    ))
            );

    private static void Write(TextWriter writer, string kind, NuScenesRide ride)
    {
        if (kind == Meta)
        {
            writer.Write(JsonLine.Of(json => WriteMeta(json, ride)) + "\n");
        }
        else if (kind == Route)
        {
            NuScenesTables.WriteList(
                writer,
                ride.Route().Select(place => (Action<Utf8JsonWriter>)(json => json.Values([place.X, place.Y], Decimals)))
            );
        }
        else
        {
            NuScenesTables.WriteList(writer, Kinds[kind](ride).Select(message => (Action<Utf8JsonWriter>)(json => Write(json, message))));
        }
    }

    private static void Write(Utf8JsonWriter json, NuScenesMessage message)
    {
        json.WriteStartObject();
        foreach ((string name, double?[] values) in message.Fields)
        {
            if (values.Length == 1)
            {
                json.Number(name, values[0], Decimals);
            }
            else
            {
                json.Numbers(name, [.. values.Select(value => value!.Value)], values.Length == 4 ? QuaternionDecimals : Decimals);
            }
        }

        json.WriteNumber("utime", message.Timestamp);
        json.WriteEndObject();
    }

    /// <summary>For each kind the number of messages, their rate, and the range, mean and deviation of each field.</summary>
    private static void WriteMeta(Utf8JsonWriter json, NuScenesRide ride)
    {
        json.WriteStartObject();
        foreach ((string kind, Func<NuScenesRide, IEnumerable<NuScenesMessage>> of) in Kinds)
        {
            NuScenesMessage[] messages = [.. of(ride)];
            double span = messages.Length == 0 ? 0 : (messages[^1].Timestamp - messages[0].Timestamp) / 1e6;
            json.WriteStartObject(kind);
            json.WriteNumber("message_count", messages.Length);
            json.Number("message_freq", span > 0 ? (messages.Length - 1) / span : 0, Decimals);
            json.Number("timespan", span, Decimals);
            json.WriteStartObject("var_stats");
            foreach (string field in messages.Take(1).SelectMany(message => message.Fields).Select(field => field.Name))
            {
                double[] values = [.. messages.SelectMany(message => message.Of(field)).OfType<double>()];
                if (values.Length > 0)
                {
                    double mean = values.Average();
                    json.WriteStartObject(field);
                    json.Number("max", values.Max(), Decimals);
                    json.Number("mean", mean, Decimals);
                    json.Number("min", values.Min(), Decimals);
                    json.Number("std", Math.Sqrt(values.Average(value => (value - mean) * (value - mean))), Decimals);
                    json.WriteEndObject();
                }
            }

            json.WriteEndObject();
            json.WriteEndObject();
        }

        json.WriteEndObject();
    }
}
