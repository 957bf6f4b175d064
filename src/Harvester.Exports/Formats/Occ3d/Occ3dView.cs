using System.Text.Json;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Occ3d;

/// <summary>What annotations.json says of a frame, which is one view of a moment.</summary>
/// <param name="Recording">Number of its session.</param>
/// <param name="Place">Number of the place that the session visits; 0 if it visits none.</param>
/// <param name="Moment">Number of its moment in the session.</param>
/// <param name="Timestamp">Time, microseconds.</param>
/// <param name="Split">The split of the session.</param>
/// <param name="Channel">Name of its camera.</param>
/// <param name="Camera">The record of the camera, as JSON.</param>
/// <param name="Ego">The record ego_pose, as JSON.</param>
internal sealed record Occ3dView(
    int Recording,
    int Place,
    int Moment,
    long Timestamp,
    string Split,
    string Channel,
    string Camera,
    string Ego
)
{
    /// <summary>The view as one line.</summary>
    public override string ToString() =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteNumber("recording", Recording);
            json.WriteNumber("place", Place);
            json.WriteNumber("moment", Moment);
            json.WriteNumber("timestamp", Timestamp);
            json.WriteString("split", Split);
            json.WriteString("channel", Channel);
            json.WritePropertyName("camera");
            json.WriteRawValue(Camera);
            json.WritePropertyName("ego");
            json.WriteRawValue(Ego);
            json.WriteEndObject();
        });

    /// <summary>Reads a line.</summary>
    public static Occ3dView Read(string line)
    {
        using JsonDocument document = JsonInput.Parse(line);
        var view = new JsonFields(document.RootElement);
        return new Occ3dView(
            view.Integer("recording"),
            view.Integer("place"),
            view.Integer("moment"),
            view.LongInteger("timestamp"),
            view.Text("split"),
            view.Text("channel"),
            view.RawText("camera"),
            view.RawText("ego")
        );
    }
}
