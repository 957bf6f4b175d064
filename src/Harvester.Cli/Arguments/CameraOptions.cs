using System.CommandLine;
using Harvester.Geometry.Cameras;

namespace Harvester.Cli.Arguments;

/// <summary>The options that describe a camera, the same wherever a command has them.</summary>
internal static class CameraOptions
{
    /// <summary>Vertical field of view.</summary>
    public static Option<double> Fov() => ValueParsers.Number(
        "--fov", "F", "Vertical field of view, degrees", value => value is > 0 and < 180, "degrees between 0 and 180, both excluded");

    /// <summary>Size of the image.</summary>
    public static Option<ImageSize> Size() => ValueParsers.Size("--size", "The image's width and height, pixels");
}
