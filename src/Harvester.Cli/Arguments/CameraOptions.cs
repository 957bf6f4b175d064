using System.CommandLine;
using Harvester.Geometry.Cameras;

namespace Harvester.Cli.Arguments;

/// <summary>The options of a camera. Several commands share them.</summary>
internal static class CameraOptions
{
    /// <summary>Vertical field of view.</summary>
    public static Option<double> Fov() =>
        ValueParsers.Number(
            "--fov",
            "F",
            "Vertical field of view, degrees",
            value => value is > 0 and < 180,
            "degrees greater than 0 and less than 180"
        );

    /// <summary>Vertical field of view of a simulated game's images.</summary>
    public static Option<double> FovOfHarvest() =>
        ValueParsers.Number("--fov", "F", "Vertical field of view, degrees", value => value is >= 1 and <= 170, "degrees from 1 to 170");

    /// <summary>Size of the image.</summary>
    public static Option<ImageSize> Size() =>
        ValueParsers.Size("--size", "Width and height of the image, pixels", new ImageSize(1, 1), ushort.MaxValue);

    /// <summary>Size of the images of a simulated game.</summary>
    public static Option<ImageSize> SizeOfHarvest() =>
        ValueParsers.Size("--size", "Width and height of the images, pixels", new ImageSize(32, 32), 8192);
}
