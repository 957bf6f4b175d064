using System.Text.Json;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>The tables of a scene's samples and of the data of its sensors.</summary>
internal static class NuScenesDataTables
{
    private const int MetreDecimals = 4;

    /// <summary>The samples.</summary>
    public static IEnumerable<Action<Utf8JsonWriter>> Samples(NuScenesScene scene) =>
        scene.Keys.Select(
            (moment, index) =>
                (Action<Utf8JsonWriter>)(
                    json =>
                    {
                        json.WriteString("token", scene.SampleTokenOf(moment));
                        json.WriteNumber("timestamp", scene.Of(moment).First().Timestamp);
                        json.WriteString("scene_token", scene.Token);
                        json.Link("prev", index > 0 ? scene.SampleTokenOf(scene.Keys[index - 1]) : null);
                        json.Link("next", index + 1 < scene.Keys.Count ? scene.SampleTokenOf(scene.Keys[index + 1]) : null);
                        NuScenesEvent.WriteTokens(json, scene.EventsOf(moment), NuScenesEvent.Ego);
                    }
                )
        );

    /// <summary>The poses of the vehicle, one for the data of each sensor.</summary>
    public static IEnumerable<Action<Utf8JsonWriter>> Poses(NuScenesScene scene) =>
        from frame in scene.Frames
        from sensor in frame.Sensors
        select (Action<Utf8JsonWriter>)(
            json =>
            {
                json.WriteString("token", scene.PoseTokenOf(sensor.Channel, frame.Moment));
                json.WriteNumber("timestamp", frame.Timestamp);
                WriteFields(json, frame.Ego, scene.Area.Offset);
            }
        );

    /// <summary>The files of the sensors; those of each sensor form a chain.</summary>
    public static IEnumerable<Action<Utf8JsonWriter>> Data(NuScenesScene scene) =>
        from channel in scene
            .Frames.SelectMany(frame => frame.Sensors.Select(sensor => (Frame: frame, Sensor: sensor)))
            .GroupBy(item => item.Sensor.Channel)
        let chain = channel.ToArray()
        from index in Enumerable.Range(0, chain.Length)
        let item = chain[index]
        select (Action<Utf8JsonWriter>)(
            json =>
            {
                json.WriteString("token", TokenAt(index));
                json.WriteString("sample_token", scene.SampleTokenOf(scene.SampleOf(item.Frame.Moment)));
                json.WriteString("ego_pose_token", scene.PoseTokenOf(channel.Key, item.Frame.Moment));
                json.WriteString("calibrated_sensor_token", scene.CalibrationTokenOf(channel.Key));
                json.WriteNumber("timestamp", item.Frame.Timestamp);
                json.WriteString("fileformat", item.Sensor.IsCamera ? Path.GetExtension(item.Sensor.File)[1..] : "pcd");
                json.WriteBoolean("is_key_frame", item.Frame.IsKey);
                json.WriteNumber("height", item.Sensor.Height);
                json.WriteNumber("width", item.Sensor.Width);
                json.WriteString("filename", item.Sensor.File);
                json.Link("prev", index > 0 ? TokenAt(index - 1) : null);
                json.Link("next", index + 1 < chain.Length ? TokenAt(index + 1) : null);

                string TokenAt(int at) => scene.DataTokenOf(channel.Key, chain[at].Frame.Moment);
            }
        );

    /// <summary>Writes the fields of an object of JSON into the object that is being written.</summary>
    /// <param name="json">The writer.</param>
    /// <param name="text">The object.</param>
    /// <param name="offset">What is added to its translation, metres.</param>
    public static void WriteFields(Utf8JsonWriter json, string text, Vector3D offset = default)
    {
        using JsonDocument document = JsonDocument.Parse(text);
        foreach (JsonProperty field in document.RootElement.EnumerateObject())
        {
            if (field.Name == "translation" && offset != default)
            {
                double[] place = new JsonFields(document.RootElement).Numbers(field.Name, 3);
                json.Numbers(field.Name, [place[0] + offset.X, place[1] + offset.Y, place[2] + offset.Z], MetreDecimals);
            }
            else
            {
                field.WriteTo(json);
            }
        }
    }
}
