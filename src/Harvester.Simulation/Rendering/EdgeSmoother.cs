using System;
using System.Runtime.Intrinsics;
using System.Threading.Tasks;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// Smooths the steps along edges in the colours alone: where a neighbouring pixel shows another triangle, the nearer of the two says
/// by its own edges how far the border lies from the pixel's centre, and the neighbour's colour gets the share it reaches in.
/// </summary>
internal sealed class EdgeSmoother(View view, ScreenTriangles triangles, int[] ids, float[] nearness)
{
    public void Smooth(RenderTarget target, byte[] before)
    {
        Array.Copy(target.Colour, before, before.Length);
        Parallel.For(0, target.Height, row =>
        {
            for (int column = 0; column < target.Width;)
            {
                if (IsWithinOneTriangle(column, row, target.Width, target.Height))
                {
                    column += Vector256<int>.Count;
                    continue;
                }

                for (int end = Math.Min(target.Width, column + Vector256<int>.Count); column < end; column++)
                {
                    Smooth(target, before, column, row);
                }
            }
        });
    }

    /// <summary>
    /// Whether each of the next few pixels of a row shows the same triangle as its neighbours do; no at the image's border.
    /// </summary>
    private bool IsWithinOneTriangle(int column, int row, int width, int height)
    {
        if (column == 0 || row == 0 || row == height - 1 || column + Vector256<int>.Count >= width)
        {
            return false;
        }

        int pixel = (row * width) + column;
        Vector256<int> own = Vector256.Create(ids, pixel);
        Vector256<int> differences = (own ^ Vector256.Create(ids, pixel - 1)) | (own ^ Vector256.Create(ids, pixel + 1))
            | (own ^ Vector256.Create(ids, pixel - width)) | (own ^ Vector256.Create(ids, pixel + width));
        return differences == Vector256<int>.Zero;
    }

    private void Smooth(RenderTarget target, byte[] before, int column, int row)
    {
        int pixel = (row * target.Width) + column;
        double share = 0;
        int neighbour = pixel;
        Consider(column > 0, -1, 0);
        Consider(column < target.Width - 1, 1, 0);
        Consider(row > 0, 0, -1);
        Consider(row < target.Height - 1, 0, 1);
        for (int channel = 0; share > 0 && channel < 3; channel++)
        {
            byte own = before[(pixel * 3) + channel];
            byte other = before[(neighbour * 3) + channel];
            target.Colour[(pixel * 3) + channel] = (byte)Math.Round(own + ((other - own) * share));
        }

        void Consider(bool isInImage, int across, int down)
        {
            int other = pixel + across + (down * target.Width);
            if (!isInImage || ids[other] == ids[pixel])
            {
                return;
            }

            double reach = ReachInto(pixel, other, view.SampleAt(column, row), view.SampleAt(column + across, row + down));
            if (reach > share)
            {
                (share, neighbour) = (reach, other);
            }
        }
    }

    /// <summary>
    /// How far, of the way between two centres, the neighbour reaches past the middle towards the pixel; 0 if it does not.
    /// </summary>
    private double ReachInto(int pixel, int neighbour, Vector2D centre, Vector2D neighbouring)
    {
        double reach = nearness[pixel] >= nearness[neighbour]
            ? 0.5 - ExitOf(triangles[ids[pixel]], centre, neighbouring, 1)
            : ExitOf(triangles[ids[neighbour]], neighbouring, centre, 0) - 0.5;
        return Math.Max(0, reach);
    }

    /// <summary>Where on the way from a point within a triangle to another the triangle ends, 0 to 1.</summary>
    private static double ExitOf(in ScreenTriangle triangle, Vector2D from, Vector2D to, double ifNowhere)
    {
        double exit = double.PositiveInfinity;
        foreach (ScreenLine edge in (ReadOnlySpan<ScreenLine>)[triangle.Edge0, triangle.Edge1, triangle.Edge2])
        {
            double start = edge.At(from.X, from.Y);
            double end = edge.At(to.X, to.Y);
            exit = end < 0 && start >= 0 ? Math.Min(exit, start / (start - end)) : exit;
        }

        return double.IsInfinity(exit) ? ifNowhere : exit;
    }
}
