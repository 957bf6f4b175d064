using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;

namespace Harvester.Datasets.Validation;

/// <summary>Checks that a frame is a view of its rig: its number, its camera and its LiDARs.</summary>
internal static class RigCheck
{
    /// <summary>Tolerance of the camera's place on the vehicle, metres: positions have four decimals, and a game moves its camera roughly.
    /// </summary>
    private const double PlaceTolerance = 0.01;

    public static IEnumerable<string> Problems(Rig rig, FrameLabel label)
    {
        int index = rig.Cameras.ToList().FindIndex(camera => camera.Name == label.View);
        if (index < 0)
        {
            yield return $"view is '{label.View}', which is no camera of the rig.";
            yield break;
        }

        RigCamera camera = rig.Cameras[index];
        if (label.Frame % rig.Cameras.Count != index || label.Frame / rig.Cameras.Count != label.Moment)
        {
            yield return FormattableString.Invariant(
                $"frame {label.Frame} is not the view '{label.View}' of moment {label.Moment}: the rig has {rig.Cameras.Count} cameras."
            );
        }

        if (label.Camera.Width != camera.Image.Width || label.Camera.Height != camera.Image.Height)
        {
            yield return $"camera.width and camera.height are {label.Camera.Width} x {label.Camera.Height}, "
                + $"but the images of '{label.View}' are {camera.Image.Width} x {camera.Image.Height}.";
        }

        if (
            label.Ego.Axes is { } axes
            && (new Pose(label.Ego.Position, axes).Compose(rig.OnVehicle(camera.Mount)).Position - label.Camera.Pose.Position).Length
                > PlaceTolerance
        )
        {
            yield return $"camera.position is not where the rig has '{label.View}' on the vehicle.";
        }

        IEnumerable<string> radars = index == 0 ? rig.Radars.Select(radar => radar.Name) : [];
        if (!(label.Channels.Get<RadarsLabel>()?.Scans ?? []).Select(scan => scan.Sensor).SequenceEqual(radars))
        {
            yield return index == 0
                ? "radar does not list each radar of the rig once, in its order."
                : "radar belongs into the line of the first view.";
        }

        string[] lidars = [.. index == 0 ? rig.Lidars.Select(lidar => lidar.Name) : []];
        if (!label.Lidar.Select(sweep => sweep.Sensor).SequenceEqual(lidars))
        {
            yield return index == 0
                ? "lidar does not list each LiDAR of the rig once, in its order."
                : "lidar belongs into the line of the first view.";
        }
    }
}
