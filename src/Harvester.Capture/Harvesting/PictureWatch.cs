using System;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Watches the pictures of a harvest for what no label can show: something drawn over the game, whose edges stay in their place while the
/// camera drives on, and colours that are clipped, as with HDR.
/// </summary>
/// <param name="image">Size of the pictures.</param>
internal sealed class PictureWatch(ImageSize image)
{
    /// <summary>The camera moves by so much between two pictures that are looked at, metres, so that edges of the world move.</summary>
    private const double StepMetres = 4;

    /// <summary>Number of pictures after which something is said.</summary>
    private const int MinPictures = 8;

    /// <summary>A pixel is clipped if one of its channels is at least this.</summary>
    private const int ClippedLevel = 253;

    /// <summary>Levels just below the clipped ones: a picture that is merely bright has as many pixels there.</summary>
    private const int BrightLevel = 228;

    /// <summary>
    /// Clipping takes all that is brighter to one level: more than this fraction of the pixels, and many times those just below.
    /// </summary>
    private const double MinClipped = 0.15;
    private const double ClippedOverBright = 4;

    private readonly StaticEdges _edges = new(image);
    private Vector3D? _last;
    private double _clipped;
    private double _bright;

    /// <summary>What is wrong with the pictures, one sentence; null if nothing is, or too few have been seen.</summary>
    public string? Warning =>
        _edges.Pictures < MinPictures ? null
        : _edges.Region is { } region
            ? $"Something is drawn over the pictures ({region}): the game's display, another mod's, or another program's."
        : _clipped / _edges.Pictures > MinClipped && _clipped > ClippedOverBright * _bright ? FormattableString.Invariant(
            $"{100 * _clipped / _edges.Pictures:0} % of the pixels are clipped, as with HDR or Auto HDR.")
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
        int clipped = 0;
        int bright = 0;
        for (int i = 0; i < picture.Bytes.Length; i += PixelBuffer.BytesPerPixel)
        {
            int greatest = Math.Max(picture.Bytes[i], Math.Max(picture.Bytes[i + 1], picture.Bytes[i + 2]));
            clipped += greatest >= ClippedLevel ? 1 : 0;
            bright += greatest is >= BrightLevel and < ClippedLevel ? 1 : 0;
        }

        _clipped += (double)clipped / image.PixelCount;
        _bright += (double)bright / image.PixelCount;
    }
}
