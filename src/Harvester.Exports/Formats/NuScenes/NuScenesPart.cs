using System.Text.Json;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>What the tables need to know of a frame, which is one view of a moment.</summary>
/// <param name="Recording">Number of its session.</param>
/// <param name="Place">Number of the place that the session visits; 0 if it visits none.</param>
/// <param name="Moment">Number of its moment in the session.</param>
/// <param name="IsKey">Whether the moment is a sample.</param>
/// <param name="Timestamp">Time, microseconds.</param>
/// <param name="Split">The split of the session.</param>
/// <param name="Description">What the scene shows.</param>
/// <param name="Area">The part of the world around the vehicle.</param>
/// <param name="HasLanes">Whether the roads of its session are known.</param>
/// <param name="Ego">The fields translation and rotation of ego_pose, as JSON.</param>
/// <param name="Sensors">Its camera, and with the first view the LiDARs.</param>
/// <param name="Objects">The objects in its image.</param>
internal sealed record NuScenesPart(
    int Recording,
    int Place,
    int Moment,
    bool IsKey,
    long Timestamp,
    string Split,
    string Description,
    NuScenesArea Area,
    bool HasLanes,
    string Ego,
    IReadOnlyList<NuScenesSensor> Sensors,
    IReadOnlyList<NuScenesObject> Objects
)
{
    /// <summary>The events that are open at the frame; null in a session without events.</summary>
    public IReadOnlyList<NuScenesEvent>? Events { get; init; }

    /// <summary>The part as one line.</summary>
    public override string ToString() =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteNumber("recording", Recording);
            json.WriteNumber("place", Place);
            json.WriteNumber("moment", Moment);
            json.WriteBoolean("key", IsKey);
            json.WriteNumber("timestamp", Timestamp);
            json.WriteString("split", Split);
            json.WriteString("description", Description);
            json.WriteString("area", Area.ToString());
            json.WriteBoolean("lanes", HasLanes);
            json.WritePropertyName("ego");
            json.WriteRawValue(Ego);
            json.WriteStartArray("sensors");
            foreach (NuScenesSensor sensor in Sensors)
            {
                sensor.Write(json);
            }

            json.WriteEndArray();
            json.WriteStartArray("objects");
            foreach (NuScenesObject item in Objects)
            {
                item.Write(json);
            }

            json.WriteEndArray();
            if (Events is { } events)
            {
                json.WriteStartArray("events");
                foreach (NuScenesEvent each in events)
                {
                    each.Write(json);
                }

                json.WriteEndArray();
            }

            json.WriteEndObject();
        });

    /// <summary>Reads a line.</summary>
    public static NuScenesPart Read(string line)
    {
        using JsonDocument document = JsonInput.Parse(line);
        var part = new JsonFields(document.RootElement);
        return new NuScenesPart(
            part.Integer("recording"),
            part.Integer("place"),
            part.Integer("moment"),
            part.Boolean("key"),
            document.RootElement.GetProperty("timestamp").GetInt64(),
            part.Text("split"),
            part.Text("description"),
            NuScenesArea.Parse(part.Text("area")),
            part.Boolean("lanes"),
            part.RawText("ego"),
            [.. part.List("sensors").Select(NuScenesSensor.Read)],
            [.. part.List("objects").Select(NuScenesObject.Read)]
        )
        {
            Events = part.Has("events") ? [.. part.List("events").Select(NuScenesEvent.Read)] : null,
        };
    }
}
