using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// Fills the pixels of a band of rows whose centres lie in a triangle that is nearer than what was drawn before. Of two triangles at the
/// same depth the first one drawn stays, so that the image does not depend on how the work is divided.
/// </summary>
internal static class BandRasteriser
{
    /// <summary>Fewer columns than this are drawn one by one.</summary>
    private const int MinColumnsAtOnce = 3;

    public static void Draw(in ScreenTriangle triangle, int id, View view, int top, int bottom, float[] nearness, int[] ids)
    {
        int first = Math.Max(top, triangle.Pixels.Top);
        int last = Math.Min(bottom, triangle.Pixels.Bottom);
        for (int row = first; row < last; row++)
        {
            if (view.Grid is null)
            {
                DrawRow(triangle, id, row, view.Camera.Width, nearness, ids);
            }
            else
            {
                DrawDistortedRow(triangle, id, row, view.Camera.Width, view.Grid, nearness, ids);
            }
        }
    }

    private static void DrawRow(in ScreenTriangle triangle, int id, int row, int width, float[] nearness, int[] ids)
    {
        double y = row + 0.5;
        (int column, int right) = triangle.Edges.ColumnsInside(y, triangle.Pixels.Left, triangle.Pixels.Right);
        double step = triangle.NearnessStep;
        double start = triangle.NearnessAt(0.5, y);
        int offset = row * width;
        for (; column <= right - MinColumnsAtOnce && column <= width - Vector256<float>.Count; column += Vector256<float>.Count)
        {
            // Eight columns at a time: nearness is linear along the row, start + step · column.
            Vector256<double> low = Vector256.Create((double)column) + Vector256.Create(0.0, 1, 2, 3);
            Vector256<double> high = Vector256.Create((double)column) + Vector256.Create(4.0, 5, 6, 7);
            Vector256<float> own = Vector256.Narrow(Vector256.Create(start) + (low * step), Vector256.Create(start) + (high * step));
            Span<float> before = nearness.AsSpan(offset + column, Vector256<float>.Count);
            Vector256<int> isWithin = Vector256.LessThan(Vector256.Create(0, 1, 2, 3, 4, 5, 6, 7), Vector256.Create(right - column));
            Vector256<float> isNearer = Vector256.GreaterThan(own, Vector256.Create<float>(before)) & isWithin.AsSingle();
            if (isNearer != Vector256<float>.Zero)
            {
                Span<int> idsBefore = ids.AsSpan(offset + column, Vector256<int>.Count);
                Vector256.ConditionalSelect(isNearer, own, Vector256.Create<float>(before)).CopyTo(before);
                Vector256.ConditionalSelect(isNearer.AsInt32(), Vector256.Create(id), Vector256.Create<int>(idsBefore)).CopyTo(idsBefore);
            }
        }

        for (; column < right; column++)
        {
            float own = (float)(start + (step * column));
            if (own > nearness[offset + column])
            {
                nearness[offset + column] = own;
                ids[offset + column] = id;
            }
        }
    }

    private static void DrawDistortedRow(
        in ScreenTriangle triangle,
        int id,
        int row,
        int width,
        SampleGrid grid,
        float[] nearness,
        int[] ids
    )
    {
        int offset = row * width;
        for (int pixel = offset + triangle.Pixels.Left; pixel < offset + triangle.Pixels.Right; pixel++)
        {
            double x = grid.U[pixel];
            double y = grid.V[pixel];
            if (Vector256.LessThanAny(triangle.Edges.At(x, y), Vector256<double>.Zero))
            {
                continue;
            }

            float own = (float)triangle.NearnessAt(x, y);
            if (own > nearness[pixel])
            {
                nearness[pixel] = own;
                ids[pixel] = id;
            }
        }
    }
}
