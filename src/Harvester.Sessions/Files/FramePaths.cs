using System.Globalization;
using Harvester.Sessions.Imaging;

namespace Harvester.Sessions.Files;

/// <summary>Paths of a frame's files within a session, with forward slashes.</summary>
public static class FramePaths
{
    /// <summary>Folder of the screenshots.</summary>
    public const string Frames = "frames";

    /// <summary>Folder of the instance masks.</summary>
    public const string Masks = "masks";

    /// <summary>Folder of the class maps.</summary>
    public const string ClassMaps = "classes";

    /// <summary>Folder of the scenes from which labels can be recomputed.</summary>
    public const string Scenes = "scenes";

    /// <summary>Path of the table of faces used for the labels.</summary>
    public const string Faces = Scenes + "/spaces.csv";

    /// <summary>Path of the roads used for the labels, if the session has them.</summary>
    public const string Roads = Scenes + "/roads.csv";

    /// <summary>Path of the events, if the session has them.</summary>
    public const string Events = "events.jsonl";

    /// <summary>Folder of the measured depths.</summary>
    public const string DepthMaps = "depth";

    /// <summary>Folder of the completed depth maps.</summary>
    public const string CompletedDepths = "depth-completed";

    /// <summary>Folder of the estimated errors of completed depth maps.</summary>
    public const string DepthErrors = "depth-error";

    /// <summary>Folder of the points of LiDARs.</summary>
    public const string Lidar = "lidar";

    /// <summary>Folder of the further pictures of moments.</summary>
    public const string Pairs = "pairs";

    /// <summary>Path of a screenshot.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="format">The format of the session's images.</param>
    /// <param name="view">The view of a rig; null without a rig.</param>
    public static string Image(int frame, ImageFormat format, string? view = null) =>
        $"{In(Frames, view)}/{Number(frame)}{format.Extension()}";

    /// <summary>Path of an instance mask.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="view">The view of a rig; null without a rig.</param>
    public static string Mask(int frame, string? view = null) => $"{In(Masks, view)}/{Number(frame)}.png";

    /// <summary>Path of a class map.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="view">The view of a rig; null without a rig.</param>
    public static string Classes(int frame, string? view = null) => $"{In(ClassMaps, view)}/{Number(frame)}.png";

    /// <summary>Path of a map of measured depths.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="view">The view of a rig; null without a rig.</param>
    public static string Depth(int frame, string? view = null) => $"{In(DepthMaps, view)}/{Number(frame)}.png";

    /// <summary>Path of a completed depth map.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="view">The view of a rig; null without a rig.</param>
    public static string CompletedDepth(int frame, string? view = null) => $"{In(CompletedDepths, view)}/{Number(frame)}.png";

    /// <summary>Path of the estimated errors of a completed depth map.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="view">The view of a rig; null without a rig.</param>
    public static string DepthError(int frame, string? view = null) => $"{In(DepthErrors, view)}/{Number(frame)}.png";

    /// <summary>Path of a map in a folder of its own.</summary>
    /// <param name="folder">The folder of the maps.</param>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="view">The view of a rig; null without a rig.</param>
    public static string Map(string folder, int frame, string? view = null) => $"{In(folder, view)}/{Number(frame)}.png";

    /// <summary>Path of the points of a LiDAR.</summary>
    /// <param name="frame">Number of the frame of the moment's first view.</param>
    /// <param name="sensor">Name of the LiDAR.</param>
    public static string Sweep(int frame, string sensor) => $"{Lidar}/{sensor}/{Number(frame)}.bin";

    /// <summary>Folder of the further pictures of a frame's moment.</summary>
    public static string PairsOf(int frame) => $"{Pairs}/{Number(frame)}";

    /// <summary>Path of a further picture of a frame's moment.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="name">What the picture shows, as a file name without its ending.</param>
    /// <param name="format">The format of the session's images.</param>
    public static string Pair(int frame, string name, ImageFormat format) => $"{PairsOf(frame)}/{name}{format.Extension()}";

    /// <summary>The folder of a view, or of a LiDAR, in a folder of the session.</summary>
    public static string In(string folder, string? view) => view is null ? folder : $"{folder}/{view}";

    /// <summary>Path of a scene.</summary>
    public static string Scene(int frame) => $"{Scenes}/{Number(frame)}.json";

    private static string Number(int frame) => frame.ToString("D8", CultureInfo.InvariantCulture);
}
