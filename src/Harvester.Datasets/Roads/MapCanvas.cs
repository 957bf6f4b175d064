using System;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.Datasets.Roads;

/// <summary>A white sheet on which smooth-edged lines are drawn.</summary>
internal sealed class MapCanvas
{
    public MapCanvas(ImageSize size)
    {
        Picture = new PixelBuffer(size);
        Array.Fill(Picture.Bytes, byte.MaxValue);
    }

    public PixelBuffer Picture { get; }

    /// <summary>Draws a line with round ends; a pixel is covered by as much as its centre is within the line's width, over one pixel.</summary>
    public void DrawLine(Vector2D from, Vector2D to, double width, RoadMapStyle style)
    {
        double reach = (width / 2) + 0.5;
        int firstColumn = Math.Max(0, (int)Math.Floor(Math.Min(from.X, to.X) - reach));
        int lastColumn = Math.Min(Picture.Size.Width - 1, (int)Math.Ceiling(Math.Max(from.X, to.X) + reach));
        int firstRow = Math.Max(0, (int)Math.Floor(Math.Min(from.Y, to.Y) - reach));
        int lastRow = Math.Min(Picture.Size.Height - 1, (int)Math.Ceiling(Math.Max(from.Y, to.Y) + reach));
        Vector2D along = to - from;
        double square = along.Dot(along);
        for (int row = firstRow; row <= lastRow; row++)
        {
            for (int column = firstColumn; column <= lastColumn; column++)
            {
                Vector2D centre = new(column + 0.5, row + 0.5);
                double part = square > 0 ? Math.Clamp((centre - from).Dot(along) / square, 0, 1) : 0;
                double cover = Math.Min(1, reach - (centre - (from + (along * part))).Length);
                if (cover > 0)
                {
                    Blend(((row * Picture.Size.Width) + column) * PixelBuffer.BytesPerPixel, style, cover);
                }
            }
        }
    }

    private void Blend(int at, RoadMapStyle style, double cover)
    {
        Picture.Bytes[at] = Mix(Picture.Bytes[at], style.Red, cover);
        Picture.Bytes[at + 1] = Mix(Picture.Bytes[at + 1], style.Green, cover);
        Picture.Bytes[at + 2] = Mix(Picture.Bytes[at + 2], style.Blue, cover);
    }

    private static byte Mix(byte under, byte over, double cover) => (byte)Math.Round(under + ((over - under) * cover));
}
