using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Watches the pictures of a harvest for what no label can show: something drawn over the game, whose edges stay in their place while the
/// camera drives on.
/// </summary>
/// <param name="image">Size of the pictures.</param>
internal sealed class PictureWatch(ImageSize image)
{
    /// <summary>The camera moves by so much between two pictures that are looked at, metres, so that edges of the world move.</summary>
    private const double StepMetres = 4;

    /// <summary>Number of pictures after which something is said.</summary>
    private const int MinPictures = 8;

    private readonly StaticEdges _edges = new(image);
    private Vector3D? _last;

    /// <summary>What is wrong with the pictures, one sentence; null if nothing is, or too few have been seen.</summary>
    public string? Warning =>
        _edges.Pictures < MinPictures ? null
        : _edges.Region is { } region
            ? $"Something is drawn over the pictures ({region}): the game's display, another mod's, or another program's."
        : null;

    /// <summary>Takes a picture, unless the camera has hardly moved since the last one.</summary>
    /// <param name="camera">Position of its camera, metres, world.</param>
    /// <param name="picture">The picture.</param>
    public void Add(Vector3D camera, PixelBuffer picture)
    {
        if (_last is { } last && (camera - last).Length < StepMetres)
        {
            return;
        }

        _last = camera;
        _edges.Add(picture);
    }
}
