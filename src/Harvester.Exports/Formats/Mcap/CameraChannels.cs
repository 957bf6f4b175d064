using Harvester.Sessions.Rigs;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>The channels of a camera, and the name of its frame of reference.</summary>
/// <param name="FrameId">Name of the frame.</param>
/// <param name="Image">Its images.</param>
/// <param name="Calibration">Its calibration.</param>
/// <param name="Annotations">What is drawn into its images.</param>
/// <param name="Depth">Its depth maps.</param>
internal sealed record CameraChannels(
    string FrameId,
    McapChannel Image,
    McapChannel Calibration,
    McapChannel Annotations,
    McapChannel Depth
)
{
    private const int PerCamera = 4;

    /// <summary>The number of the first channel of a rig. Smaller ones are those of <see cref="McapChannel.All"/>.</summary>
    private const int FirstOfRigs = 64;

    /// <summary>The number of the first channel of a LiDAR, after those of all cameras that a rig may have.</summary>
    private const int FirstOfLidars = FirstOfRigs + (PerCamera * RigParser.MaxCameras);

    /// <summary>Those of the camera of a session without a rig.</summary>
    public static CameraChannels Single { get; } =
        new("camera", McapChannel.Image, McapChannel.Calibration, McapChannel.Annotations, McapChannel.Depth);

    /// <summary>Those of a camera of a rig.</summary>
    /// <param name="rig">The rig.</param>
    /// <param name="view">Number of the camera in the rig, from 0.</param>
    public static CameraChannels Of(Rig rig, int view)
    {
        string camera = $"camera/{rig.Cameras[view].Name}";
        int first = FirstOfRigs + (PerCamera * view);
        return new CameraChannels(
            camera,
            new McapChannel(first, $"/{camera}/image", McapChannel.Image.Schema),
            new McapChannel(first + 1, $"/{camera}/calibration", McapChannel.Calibration.Schema),
            new McapChannel(first + 2, $"/{camera}/annotations", McapChannel.Annotations.Schema),
            new McapChannel(first + 3, $"/{camera}/depth", McapChannel.Depth.Schema)
        );
    }

    /// <summary>The channel of a LiDAR of a rig.</summary>
    /// <param name="rig">The rig.</param>
    /// <param name="lidar">The LiDAR.</param>
    public static McapChannel OfLidar(Rig rig, RigLidar lidar) =>
        new(
            FirstOfLidars + rig.Lidars.TakeWhile(other => other.Name != lidar.Name).Count(),
            "/" + LidarFrame(lidar),
            MessageSchemas.PointCloud
        );

    /// <summary>Name of the frame of reference of a LiDAR.</summary>
    public static string LidarFrame(RigLidar lidar) => $"lidar/{lidar.Name}";
}
