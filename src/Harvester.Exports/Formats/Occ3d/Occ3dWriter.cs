using System.Text.Json;
using Harvester.Exports.Formats.NuScenes;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Occ3d;

/// <summary>
/// Writes the layout of Occ3D-nuScenes: the images, the voxels of each moment, and annotations.json. Scenes and tokens are those of the
/// nuScenes export of the same sessions. See docs/exports/occ3d.md.
/// </summary>
internal sealed class Occ3dWriter : IDatasetWriter
{
    private const string FramePart = "frame";
    private const int MetreDecimals = 6;
    private const int QuaternionDecimals = 9;
    private const int PixelDecimals = 6;

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        FrameLabel label = frame.Label;
        OccupancyLabel voxels = label.Channels.Get<OccupancyLabel>()!;
        var labels = Occ3dLabels.Of(frame, voxels);
        string channel = label.View ?? NuScenesWriter.FrontCamera;
        long timestamp = NuScenesWriter.TimestampOf(frame, label.TimeSeconds);
        string image = FormattableString.Invariant(
            $"{Occ3dFiles.Images}/{channel}/{NuScenesWriter.LogOf(frame)}__{channel}__{timestamp}{frame.ImageExtension}"
        );
        output.Image(image, frame);

        // The ego's frame is that of the voxels, whose axes are those of the vehicle's model.
        Pose vehicle = new(label.Ego.Position, label.Ego.Axes ?? Axes.FromHeading(label.Ego.HeadingDegrees));
        Pose ego = vehicle with { Position = vehicle.ToWorld(voxels.Origin) };
        var view = new Occ3dView(
            frame.RecordingIndex,
            label.Place ?? 0,
            label.Moment ?? label.Frame,
            timestamp,
            frame.Split,
            channel,
            CameraOf(label.Camera, ego, image),
            JsonLine.Of(json => WritePose(json, ego.Position, Rotation.OfBody(ego.Axes)))
        );
        output.Part(FramePart, view.ToString());
        output.StagedPart(Occ3dScenes.PartOf(view), $"{frame.Name}.npz", labels.Write);
        if (NuScenesWriter.IsSample(frame))
        {
            output.Part(Occ3dScenes.KeyOf(view), "");
        }

        return default;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts)
    {
        var scenes = new Occ3dScenes(parts.Keys);
        return
        [
            .. scenes.Files.Select(file => new AggregateFile(file.Path, [AggregateSection.Container(file.Part, Occ3dLabels.Merge)])),
            new AggregateFile(
                Occ3dFiles.Annotations,
                [AggregateSection.Summary(FramePart, (writer, lines) => Occ3dAnnotations.Write(writer, lines, scenes))]
            ),
        ];
    }

    private static string CameraOf(CameraLabel camera, Pose ego, string image) =>
        JsonLine.Of(json =>
        {
            Pose pose = camera.Pose;
            var axes = Axes.FromVectors(
                InEgo(ego.Axes.ToLocal(pose.Axes.Right)),
                InEgo(ego.Axes.ToLocal(pose.Axes.Forward)),
                InEgo(ego.Axes.ToLocal(pose.Axes.Up))
            );
            json.WriteStartObject();
            json.WriteString("img_path", image);
            json.WriteStartArray("intrinsic");
            json.Values([camera.Fx, 0, camera.Cx], PixelDecimals);
            json.Values([0, camera.Fy, camera.Cy], PixelDecimals);
            json.Values([0, 0, 1], PixelDecimals);
            json.WriteEndArray();
            json.WritePropertyName("extrinsic");
            WritePose(json, InEgo(ego.ToLocal(pose.Position)), Rotation.OfCamera(axes));
            json.WritePropertyName("ego_pose");
            WritePose(json, ego.Position, Rotation.OfBody(ego.Axes));
            json.WriteEndObject();
        });

    /// <summary>A vector of the vehicle (x right, y forward, z up) in the ego's frame: x forward, y left, z up.</summary>
    private static Vector3D InEgo(Vector3D vector) => new(vector.Y, -vector.X, vector.Z);

    private static void WritePose(Utf8JsonWriter json, Vector3D place, Rotation rotation)
    {
        json.WriteStartObject();
        json.Numbers("translation", [place.X, place.Y, place.Z], MetreDecimals);
        json.Numbers("rotation", [rotation.W, rotation.X, rotation.Y, rotation.Z], QuaternionDecimals);
        json.WriteEndObject();
    }
}
