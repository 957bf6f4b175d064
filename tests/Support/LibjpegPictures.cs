using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.TestSupport;

/// <summary>The pictures that tests/Libjpeg/make.py wrote with libjpeg.</summary>
internal static class LibjpegPictures
{
    /// <summary>The picture of quality-50.jpg, quality-95.jpg and quality-100.jpg before it was compressed.</summary>
    public static PixelBuffer Pattern
    {
        get
        {
            var picture = new PixelBuffer(new ImageSize(45, 29));
            for (int y = 0, at = 0; y < picture.Size.Height; y++)
            {
                for (int x = 0; x < picture.Size.Width; x++)
                {
                    picture.Bytes[at++] = (byte)((x * 11) + (y * 7));
                    picture.Bytes[at++] = (byte)((x * x * 3) + y);
                    picture.Bytes[at++] = (byte)(x ^ (y * 5));
                }
            }

            return picture;
        }
    }

    public static string PathOf(string name) => Path.Combine(AppContext.BaseDirectory, "Libjpeg", name);
}
