using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.OpenLabel;

/// <summary>The beginning of a file: metadata, coordinate systems and the stream of the camera.</summary>
internal static class OpenLabelStream
{
    /// <summary>Version of the format.</summary>
    public const string SchemaVersion = "1.0.0";

    /// <summary>The coordinate system with x east, y north and z up.</summary>
    public const string World = "world";

    /// <summary>The coordinate system of the car: x forward, y left, z up.</summary>
    public const string Ego = "ego";

    /// <summary>The coordinate system of the camera, x right, y down, z forward, and the name of its stream.</summary>
    public const string Camera = "camera";

    private const int Decimals = 6;

    /// <summary>The first line of a file, up to the stream.</summary>
    public const string Head =
        "{\"openlabel\":{\"metadata\":{\"schema_version\":\""
        + SchemaVersion
        + "\",\"annotator\":\"GtaDataHarvester\"},"
        + "\"coordinate_systems\":{"
        + "\""
        + World
        + "\":{\"type\":\"scene_cs\",\"parent\":\"\",\"children\":[\""
        + Ego
        + "\",\""
        + Camera
        + "\"]},"
        + "\""
        + Ego
        + "\":{\"type\":\"local_cs\",\"parent\":\""
        + World
        + "\",\"children\":[]},"
        + "\""
        + Camera
        + "\":{\"type\":\"sensor_cs\",\"parent\":\""
        + World
        + "\",\"children\":[]}},"
        + "\"streams\":{\""
        + Camera
        + "\":";

    /// <summary>The stream of a camera. OpenCV's coefficients are k1, k2, p1, p2 and k3.</summary>
    public static string Text(CameraLabel camera) =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteString("type", "camera");
            json.WriteStartObject("stream_properties");
            json.WriteStartObject("intrinsics_pinhole");
            json.WriteNumber("width_px", camera.Width);
            json.WriteNumber("height_px", camera.Height);
            json.Numbers("camera_matrix", [camera.Fx, 0, camera.Cx, 0, 0, camera.Fy, camera.Cy, 0, 0, 0, 1, 0], Decimals);
            json.Numbers("distortion_coeffs", [camera.Distortion.K1, camera.Distortion.K2, 0, 0, 0], Decimals);
            json.WriteEndObject();
            json.WriteEndObject();
            json.WriteEndObject();
        });
}
