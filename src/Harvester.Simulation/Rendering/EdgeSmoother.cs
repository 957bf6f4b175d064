using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// Smooths the steps along edges, in the colours only: where a neighbouring pixel shows another triangle, the edges of the nearer triangle
/// give the border's distance from the pixel's centre, and the neighbour's colour is mixed in by the fraction that it covers.
/// </summary>
internal sealed class EdgeSmoother(View view, ScreenTriangles triangles, int[] ids, float[] nearness)
{
    private static readonly (int Across, int Down)[] Sides = [(-1, 0), (1, 0), (0, -1), (0, 1)];

    public void Smooth(RenderTarget target, byte[] before)
    {
        Array.Copy(target.Colour, before, before.Length);
        Parallel.For(
            0,
            target.Height,
            row =>
            {
                for (int column = 0; column < target.Width; column += Vector256<int>.Count)
                {
                    for (uint borders = BordersAt(column, row, target.Width, target.Height); borders != 0; borders &= borders - 1)
                    {
                        Smooth(target, before, column + BitOperations.TrailingZeroCount(borders), row);
                    }
                }
            }
        );
    }

    /// <summary>
    /// Which of the next few pixels of a row may show another triangle than a neighbour does, as bits from the lowest; at the image's
    /// border all of them.
    /// </summary>
    private uint BordersAt(int column, int row, int width, int height)
    {
        if (column == 0 || row == 0 || row == height - 1 || column + Vector256<int>.Count >= width)
        {
            return (1u << Math.Min(Vector256<int>.Count, width - column)) - 1;
        }

        int pixel = (row * width) + column;
        Vector256<int> own = Vector256.Create(ids, pixel);
        Vector256<int> differences =
            (own ^ Vector256.Create(ids, pixel - 1))
            | (own ^ Vector256.Create(ids, pixel + 1))
            | (own ^ Vector256.Create(ids, pixel - width))
            | (own ^ Vector256.Create(ids, pixel + width));
        return ~Vector256.Equals(differences, Vector256<int>.Zero).ExtractMostSignificantBits() & 0xFF;
    }

    private void Smooth(RenderTarget target, byte[] before, int column, int row)
    {
        int pixel = (row * target.Width) + column;
        if (!CanChange(target, before, column, row))
        {
            return;
        }

        double share = 0;
        int neighbour = pixel;
        ref readonly ScreenTriangle own = ref ids[pixel] == ScreenTriangles.Nothing
            ? ref Unsafe.NullRef<ScreenTriangle>()
            : ref triangles[ids[pixel]];
        foreach ((int across, int down) in Sides)
        {
            int other = pixel + across + (down * target.Width);
            if (!IsBorder(target, column, row, across, down))
            {
                continue;
            }

            // How far, of the way between two centres, the neighbour reaches past the middle towards the pixel.
            Vector2D centre = view.SampleAt(column, row);
            Vector2D neighbouring = view.SampleAt(column + across, row + down);
            double reach =
                nearness[pixel] >= nearness[other]
                    ? 0.5 - ExitOf(own, centre, neighbouring, 1)
                    : ExitOf(triangles[ids[other]], neighbouring, centre, 0) - 0.5;
            if (reach > share)
            {
                (share, neighbour) = (reach, other);
            }
        }

        for (int channel = 0; share > 0 && channel < 3; channel++)
        {
            byte from = before[(pixel * 3) + channel];
            byte to = before[(neighbour * 3) + channel];
            target.Colour[(pixel * 3) + channel] = (byte)Math.Round(from + ((to - from) * share));
        }
    }

    /// <summary>Whether a neighbour that shows another triangle has another colour.</summary>
    private bool CanChange(RenderTarget target, byte[] before, int column, int row)
    {
        int pixel = (row * target.Width) + column;
        foreach ((int across, int down) in Sides)
        {
            int other = pixel + across + (down * target.Width);
            if (IsBorder(target, column, row, across, down) && !before.AsSpan(pixel * 3, 3).SequenceEqual(before.AsSpan(other * 3, 3)))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Whether a neighbour lies in the image and shows another triangle.</summary>
    private bool IsBorder(RenderTarget target, int column, int row, int across, int down)
    {
        int pixel = (row * target.Width) + column;
        return (uint)(column + across) < (uint)target.Width
            && (uint)(row + down) < (uint)target.Height
            && ids[pixel + across + (down * target.Width)] != ids[pixel];
    }

    /// <summary>Where the segment from a point within a triangle to another point leaves the triangle, 0 to 1.</summary>
    private static double ExitOf(in ScreenTriangle triangle, Vector2D from, Vector2D to, double ifNowhere)
    {
        Vector256<double> start = triangle.Edges.At(from.X, from.Y);
        Vector256<double> end = triangle.Edges.At(to.X, to.Y);
        Vector256<double> isLeft =
            Vector256.LessThan(end, Vector256<double>.Zero) & Vector256.GreaterThanOrEqual(start, Vector256<double>.Zero);
        if (isLeft == Vector256<double>.Zero)
        {
            return ifNowhere;
        }

        // An edge function is linear, so it is 0 at the fraction start / (start - end) of the way; the first edge that is left counts.
        Vector256<double> exits = Vector256.ConditionalSelect(isLeft, start / (start - end), Vector256<double>.One);
        Vector128<double> first = Vector128.MinNative(exits.GetLower(), exits.GetUpper());
        return Math.Min(first[0], first[1]);
    }
}
