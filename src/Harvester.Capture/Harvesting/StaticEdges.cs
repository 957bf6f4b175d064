using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Finds edges that are in the same place, with the same colours, in all pictures of a moving camera: what is drawn over the picture. A
/// plain sky has no edges, and edges of the world move.
/// </summary>
/// <param name="image">Size of the pictures.</param>
internal sealed class StaticEdges(ImageSize image)
{
    /// <summary>Neighbouring pixels on the two sides of an edge differ by more, grey levels.</summary>
    private const int EdgeLevels = 40;

    /// <summary>A pixel that stays differs by less from the first picture, grey levels: noise and compression.</summary>
    private const int SameLevels = 16;

    /// <summary>Fewer pixels at edges are chance, as where the horizon crosses itself.</summary>
    private const int MinPixels = 24;

    private PixelBuffer? _first;
    private bool[] _stays = [];

    /// <summary>Number of pictures.</summary>
    public int Pictures { get; private set; }

    /// <summary>The region of the edges; null if there are none.</summary>
    public PictureRegion? Region
    {
        get
        {
            var pixels = new List<int>();
            for (int pixel = 0; pixel < _stays.Length; pixel++)
            {
                if (_stays[pixel])
                {
                    pixels.Add(pixel);
                }
            }

            return Pictures > 1 && pixels.Count >= MinPixels ? PictureRegion.Of(pixels, image) : null;
        }
    }

    /// <summary>Adds a picture.</summary>
    public void Add(PixelBuffer picture)
    {
        Pictures++;
        if (_first is null)
        {
            _first = new PixelBuffer(image);
            Buffer.BlockCopy(picture.Bytes, 0, _first.Bytes, 0, picture.Bytes.Length);
            _stays = EdgesOf(picture);
            return;
        }

        for (int pixel = 0; pixel < _stays.Length; pixel++)
        {
            _stays[pixel] = _stays[pixel] && Stays(picture, pixel) && Stays(picture, pixel + 1);
        }
    }

    private bool Stays(PixelBuffer picture, int pixel) => PicturePixels.Difference(_first!, picture, pixel) <= SameLevels;

    /// <summary>The pixels that differ clearly from their right neighbours.</summary>
    private bool[] EdgesOf(PixelBuffer picture)
    {
        var edges = new bool[image.PixelCount];
        for (int pixel = 0; pixel < edges.Length; pixel++)
        {
            if ((pixel + 1) % image.Width != 0)
            {
                int here = PixelBuffer.BytesPerPixel * pixel;
                int greatest = 0;
                for (int channel = 0; channel < PixelBuffer.BytesPerPixel; channel++)
                {
                    greatest = Math.Max(
                        greatest,
                        Math.Abs(picture.Bytes[here + channel] - picture.Bytes[here + channel + PixelBuffer.BytesPerPixel])
                    );
                }

                edges[pixel] = greatest > EdgeLevels;
            }
        }

        return edges;
    }
}
