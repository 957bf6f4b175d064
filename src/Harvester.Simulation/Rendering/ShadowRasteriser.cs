using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>Raises the texels of a shadow map whose centres a triangle covers.</summary>
internal static class ShadowRasteriser
{
    /// <summary>Raises the texels that lie in some tiles. A texel's new height does not depend on which tiles these are.</summary>
    /// <param name="a">First corner: texels across and along, and metres towards the light.</param>
    /// <param name="b">Second corner.</param>
    /// <param name="c">Third corner.</param>
    /// <param name="heights">The map, row by row.</param>
    /// <param name="size">Its rows and columns.</param>
    /// <param name="tiles">The tiles.</param>
    public static void Draw(Vector256<double> a, Vector256<double> b, Vector256<double> c, float[] heights, int size, ShadowTiles tiles)
    {
        Vector256<double> min = Vector256.MinNative(a, Vector256.MinNative(b, c));
        Vector256<double> max = Vector256.MaxNative(a, Vector256.MaxNative(b, c));
        int left = (int)Math.Clamp(Math.Ceiling(min[0] - 0.5), 0, size);
        int right = (int)Math.Clamp(Math.Ceiling(max[0] - 0.5), 0, size);
        int bottom = (int)Math.Clamp(Math.Ceiling(min[1] - 0.5), 0, size);
        int top = (int)Math.Clamp(Math.Ceiling(max[1] - 0.5), 0, size);
        if (left >= right || bottom >= top || !tiles.HasAnyIn(left, bottom, right, top))
        {
            return;
        }

        double doubleArea = ((b[0] - a[0]) * (c[1] - a[1])) - ((b[1] - a[1]) * (c[0] - a[0]));
        if (doubleArea == 0)
        {
            return;
        }

        EdgeTriple edges = doubleArea > 0 ? new EdgeTriple(a, b, c) : new EdgeTriple(b, a, c);
        Vector256<double> ab = b - a;
        Vector256<double> ac = c - a;
        double stepX = ((ab[2] * ac[1]) - (ac[2] * ab[1])) / doubleArea;
        double stepY = ((ac[2] * ab[0]) - (ab[2] * ac[0])) / doubleArea;
        ulong across = tiles.ColumnsOf(left, right);
        for (int row = bottom; row < top; row++)
        {
            ulong columns = tiles.ColumnsAt(row) & across;
            if (columns == 0)
            {
                continue;
            }

            (int first, int last) = edges.ColumnsInside(row + 0.5, left, right);
            double height = a[2] + (stepX * (first + 0.5 - a[0])) + (stepY * (row + 0.5 - a[1]));
            Span<float> texels = heights.AsSpan(row * size, size);
            if (columns == across)
            {
                Raise(texels, first, first, last, height, stepX);
                continue;
            }

            while (columns != 0)
            {
                (int from, int to) = tiles.TakeStretch(ref columns);
                Raise(texels, first, Math.Max(first, from), Math.Min(last, to), height, stepX);
            }
        }
    }

    /// <summary>Raises the texels [from, to) of a row to heights that are counted from the first texel within the triangle.</summary>
    private static void Raise(Span<float> texels, int first, int from, int to, double height, double step)
    {
        int column = from;
        for (; column <= to - Vector256<float>.Count; column += Vector256<float>.Count)
        {
            Vector256<double> low = Vector256.Create((double)(column - first)) + Vector256.Create(0.0, 1, 2, 3);
            Vector256<double> high = Vector256.Create((double)(column - first)) + Vector256.Create(4.0, 5, 6, 7);
            Vector256<float> own = Vector256.Narrow(
                Vector256.Create(height) + (Vector256.Create(step) * low),
                Vector256.Create(height) + (Vector256.Create(step) * high)
            );
            Span<float> before = texels.Slice(column, Vector256<float>.Count);
            Vector256.Max(Vector256.Create<float>(before), own).CopyTo(before);
        }

        for (; column < to; column++)
        {
            texels[column] = Math.Max(texels[column], (float)(height + (step * (column - first))));
        }
    }
}
