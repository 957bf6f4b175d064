using Harvester.Geometry;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>Compares the pixels of pictures of one size.</summary>
internal static class PicturePixels
{
    /// <summary>The greatest difference of a pixel's channels, grey levels.</summary>
    public static int Difference(PixelBuffer a, PixelBuffer b, int pixel)
    {
        int greatest = 0;
        for (int i = PixelBuffer.BytesPerPixel * pixel; i < PixelBuffer.BytesPerPixel * (pixel + 1); i++)
        {
            greatest = Math.Max(greatest, Math.Abs(a.Bytes[i] - b.Bytes[i]));
        }

        return greatest;
    }

    /// <summary>The pixels that differ by more than a number of grey levels.</summary>
    public static List<int> Changed(PixelBuffer a, PixelBuffer b, int levels)
    {
        var changed = new List<int>();
        for (int pixel = 0; pixel < a.Size.PixelCount; pixel++)
        {
            if (Difference(a, b, pixel) > levels)
            {
                changed.Add(pixel);
            }
        }

        return changed;
    }

    /// <summary>Number of pixels in a box that differ by more than a number of grey levels.</summary>
    public static int ChangedIn(Box2D box, PixelBuffer a, PixelBuffer b, int levels)
    {
        int count = 0;
        for (int row = Math.Max(0, (int)box.YMin); row < Math.Min(a.Size.Height, (int)Math.Ceiling(box.YMax)); row++)
        {
            for (int column = Math.Max(0, (int)box.XMin); column < Math.Min(a.Size.Width, (int)Math.Ceiling(box.XMax)); column++)
            {
                count += Difference(a, b, (row * a.Size.Width) + column) > levels ? 1 : 0;
            }
        }

        return count;
    }

    /// <summary>The mean colour of a box, channel by channel, grey levels.</summary>
    public static Vector3D MeanOf(PixelBuffer picture, Box2D box)
    {
        Vector3D sum = Vector3D.Zero;
        int count = 0;
        for (int row = Math.Max(0, (int)box.YMin); row < Math.Min(picture.Size.Height, (int)Math.Ceiling(box.YMax)); row++)
        {
            for (int column = Math.Max(0, (int)box.XMin); column < Math.Min(picture.Size.Width, (int)Math.Ceiling(box.XMax)); column++)
            {
                int first = PixelBuffer.BytesPerPixel * ((row * picture.Size.Width) + column);
                sum += new Vector3D(picture.Bytes[first], picture.Bytes[first + 1], picture.Bytes[first + 2]);
                count++;
            }
        }

        return count == 0 ? Vector3D.Zero : sum * (1.0 / count);
    }
}
