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

    /// <summary>Path of a screenshot.</summary>
    public static string Image(int frame, ImageFormat format) => $"{Frames}/{Number(frame)}{format.Extension()}";

    /// <summary>Path of an instance mask.</summary>
    public static string Mask(int frame) => $"{Masks}/{Number(frame)}.png";

    /// <summary>Path of a class map.</summary>
    public static string Classes(int frame) => $"{ClassMaps}/{Number(frame)}.png";

    /// <summary>Path of a scene.</summary>
    public static string Scene(int frame) => $"{Scenes}/{Number(frame)}.json";

    private static string Number(int frame) => frame.ToString("D8", CultureInfo.InvariantCulture);
}
