using System.Text.Json;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Rigs;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>A file of a sensor at one moment: an image, the points of a LiDAR, or the detections of a radar.</summary>
/// <param name="Channel">Name of the sensor.</param>
/// <param name="File">Path in the dataset.</param>
/// <param name="Width">Width of the image, pixels; 0 for points.</param>
/// <param name="Height">Height of the image, pixels; 0 for points.</param>
/// <param name="Calibration">The fields translation, rotation and camera_intrinsic of calibrated_sensor, as JSON.</param>
internal sealed record NuScenesSensor(string Channel, string File, int Width, int Height, string Calibration)
{
    private const int MetreDecimals = 6;
    private const int QuaternionDecimals = 9;
    private const int PixelDecimals = 6;

    /// <summary>Extension of the files of radars; those of LiDARs have another.</summary>
    public const string RadarExtension = ".pcd";

    /// <summary>What kind of sensor a LiDAR is, as the tables say.</summary>
    public const string Lidar = "lidar";

    /// <summary>Whether it is a camera.</summary>
    public bool IsCamera => Width > 0;

    /// <summary>What kind of sensor it is, as the tables say.</summary>
    public string Modality =>
        IsCamera ? "camera"
        : IsRadar(File) ? "radar"
        : Lidar;

    /// <summary>Whether a file is that of a radar.</summary>
    public static bool IsRadar(string file) => file.EndsWith(RadarExtension, StringComparison.Ordinal);

    /// <summary>The sensor of a view.</summary>
    public static NuScenesSensor Of(RigCamera camera, CameraLabel label, string file)
    {
        return new NuScenesSensor(
            camera.Name,
            file,
            label.Width,
            label.Height,
            CalibrationOf(camera.Mount, Rotation.OfCamera(InEgo(camera.Mount.Axes)), label)
        );
    }

    /// <summary>The sensor of a LiDAR, whose axes are nuScenes' own: x right, y forward, z up.</summary>
    public static NuScenesSensor Of(RigLidar lidar, string file) =>
        new(lidar.Name, file, 0, 0, CalibrationOf(lidar.Mount, Rotation.OfSensor(InEgo(lidar.Mount.Axes)), null));

    /// <summary>The sensor of a radar, whose axes are nuScenes' own: x forward, y left, z up.</summary>
    public static NuScenesSensor Of(RigRadar radar, string file) =>
        new(radar.Name, file, 0, 0, CalibrationOf(radar.Mount, Rotation.OfBody(InEgo(radar.Mount.Axes)), null));

    /// <summary>Writes the sensor.</summary>
    public void Write(Utf8JsonWriter json)
    {
        json.WriteStartObject();
        json.WriteString("channel", Channel);
        json.WriteString("file", File);
        json.WriteNumber("width", Width);
        json.WriteNumber("height", Height);
        json.WritePropertyName("calibration");
        json.WriteRawValue(Calibration);
        json.WriteEndObject();
    }

    /// <summary>Reads what <see cref="Write"/> wrote.</summary>
    public static NuScenesSensor Read(JsonFields sensor) =>
        new(sensor.Text("channel"), sensor.Text("file"), sensor.Integer("width"), sensor.Integer("height"), sensor.RawText("calibration"));

    /// <summary>A vector of the vehicle (x right, y forward, z up) in the ego frame of nuScenes: x forward, y left, z up.</summary>
    private static Vector3D InEgo(Vector3D vector) => new(vector.Y, -vector.X, vector.Z);

    private static Axes InEgo(Axes axes) => Axes.FromVectors(InEgo(axes.Right), InEgo(axes.Forward), InEgo(axes.Up));

    private static string CalibrationOf(Pose mount, Rotation rotation, CameraLabel? camera) =>
        JsonLine.Of(json =>
        {
            Vector3D place = InEgo(mount.Position);
            json.WriteStartObject();
            json.Numbers("translation", [place.X, place.Y, place.Z], MetreDecimals);
            json.Numbers("rotation", [rotation.W, rotation.X, rotation.Y, rotation.Z], QuaternionDecimals);
            json.WriteStartArray("camera_intrinsic");
            if (camera is not null)
            {
                json.Values([camera.Fx, 0, camera.Cx], PixelDecimals);
                json.Values([0, camera.Fy, camera.Cy], PixelDecimals);
                json.Values([0, 0, 1], PixelDecimals);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        });
}
