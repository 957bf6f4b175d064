using Harvester.Sessions.Files;

namespace Harvester.Sessions.Labels;

/// <summary>All channels. Their order is that of their fields in a label and of their files in the manifest.</summary>
public static class FrameChannels
{
    /// <summary>The channel of class maps.</summary>
    public static ClassMapChannel ClassMaps { get; } = new();

    /// <summary>The channel of depth maps.</summary>
    public static DepthChannel Depth { get; } = new();

    /// <summary>The channel of the points of LiDARs.</summary>
    public static SweepsChannel Sweeps { get; } = new();

    /// <summary>The channel of further pictures.</summary>
    public static PairsChannel Pairs { get; } = new();

    /// <summary>The channel of maps of normals.</summary>
    public static MapChannel Normals { get; } =
        new("normals", "map of normals", 24, new ChannelSwitch("Normals", "the normals of the surfaces, in the camera's frame"));

    /// <summary>The channel of dense motion.</summary>
    public static FlowChannel Flow { get; } = new();

    /// <summary>The channel of bird's-eye maps.</summary>
    public static BirdsEyeChannel BirdsEye { get; } = new();

    /// <summary>The channel of voxels.</summary>
    public static OccupancyChannel Occupancy { get; } = new();

    /// <summary>The channel of the detections of radars.</summary>
    public static RadarsChannel Radars { get; } = new();

    /// <summary>The channel of the inertial unit.</summary>
    public static ImuChannel Imu { get; } = new();

    /// <summary>The channel of the satellite receiver.</summary>
    public static GnssChannel Gnss { get; } = new();

    /// <summary>The channels whose fields stand before the rays.</summary>
    internal static IReadOnlyList<FrameChannel> Maps { get; } = [ClassMaps, Depth, Normals, Flow, BirdsEye, Occupancy];

    /// <summary>The channels whose fields stand after the rays.</summary>
    internal static IReadOnlyList<FrameChannel> Others { get; } = [Sweeps, Pairs, Imu, Gnss, Radars];

    /// <summary>All channels.</summary>
    public static IReadOnlyList<FrameChannel> All { get; } = [.. Maps, .. Others];

    /// <summary>The folders of a session that hold files of frames.</summary>
    public static IReadOnlyList<string> Folders { get; } =
    [FramePaths.Frames, FramePaths.Masks, .. All.SelectMany(channel => channel.Folders), FramePaths.Scenes];
}
