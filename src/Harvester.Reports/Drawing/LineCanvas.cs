using Harvester.Geometry;
using Harvester.Sessions.Imaging;

namespace Harvester.Reports.Drawing;

/// <summary>Draws anti-aliased lines with round ends on an image.</summary>
/// <param name="picture">The image, which is changed.</param>
internal sealed class LineCanvas(PixelBuffer picture)
{
    /// <summary>Draws a line, clipped to the image.</summary>
    /// <param name="start">One end, pixels from the upper left corner of the image.</param>
    /// <param name="end">The other end.</param>
    /// <param name="width">Width, pixels.</param>
    /// <param name="colour">0xRRGGBB.</param>
    /// <param name="opacity">0 to 1.</param>
    public void Line(Vector2D start, Vector2D end, double width, int colour, double opacity = 1)
    {
        double reach = (width / 2) + 1;
        int left = Clamp(Math.Min(start.X, end.X) - reach, picture.Size.Width);
        int right = Clamp(Math.Max(start.X, end.X) + reach, picture.Size.Width);
        int top = Clamp(Math.Min(start.Y, end.Y) - reach, picture.Size.Height);
        int bottom = Clamp(Math.Max(start.Y, end.Y) + reach, picture.Size.Height);
        for (int row = top; row < bottom; row++)
        {
            for (int column = left; column < right; column++)
            {
                // Coverage is 1 within the line's half width and falls to 0 over one pixel at the edge.
                double coverage = (width / 2) + 0.5 - Distance(new Vector2D(column + 0.5, row + 0.5), start, end);
                if (coverage > 0)
                {
                    Blend(column, row, colour, Math.Min(1, coverage) * opacity);
                }
            }
        }
    }

    /// <summary>Draws the outline of a box. See <see cref="Line"/>.</summary>
    public void Rectangle(Box2D box, double width, int colour, double opacity)
    {
        var upperLeft = new Vector2D(box.XMin, box.YMin);
        var upperRight = new Vector2D(box.XMax, box.YMin);
        var lowerRight = new Vector2D(box.XMax, box.YMax);
        var lowerLeft = new Vector2D(box.XMin, box.YMax);
        Line(upperLeft, upperRight, width, colour, opacity);
        Line(upperRight, lowerRight, width, colour, opacity);
        Line(lowerRight, lowerLeft, width, colour, opacity);
        Line(lowerLeft, upperLeft, width, colour, opacity);
    }

    private static int Clamp(double value, int max) => (int)Math.Clamp(Math.Floor(value), 0, max);

    private static double Distance(Vector2D point, Vector2D start, Vector2D end)
    {
        Vector2D along = end - start;
        double lengthSquared = along.Dot(along);
        double position = lengthSquared == 0 ? 0 : Math.Clamp((point - start).Dot(along) / lengthSquared, 0, 1);
        return (point - (start + (along * position))).Length;
    }

    private void Blend(int column, int row, int colour, double share)
    {
        Span<byte> pixel = picture.Bytes.AsSpan(
            ((row * picture.Size.Width) + column) * PixelBuffer.BytesPerPixel,
            PixelBuffer.BytesPerPixel
        );
        for (int channel = 0; channel < pixel.Length; channel++)
        {
            int wanted = (colour >> (8 * (2 - channel))) & 0xFF;
            pixel[channel] = (byte)Math.Round(pixel[channel] + ((wanted - pixel[channel]) * share));
        }
    }
}
