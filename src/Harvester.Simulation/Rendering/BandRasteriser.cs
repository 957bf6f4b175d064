using System;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// Fills the pixels of a band of rows whose centres lie in a triangle that is nearer than what is there. Of two triangles at the
/// same depth the first one given stays, so that the picture does not depend on how the work is shared out.
/// </summary>
internal static class BandRasteriser
{
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
        int left = triangle.Pixels.Left;
        int right = triangle.Pixels.Right;
        if (!Narrow(triangle.Edge0, y, ref left, ref right)
            || !Narrow(triangle.Edge1, y, ref left, ref right)
            || !Narrow(triangle.Edge2, y, ref left, ref right))
        {
            return;
        }

        double step = triangle.Nearness.X;
        double start = triangle.Nearness.At(0.5, y);
        int offset = row * width;
        for (int column = left; column < right; column++)
        {
            float own = (float)(start + (step * column));
            if (own > nearness[offset + column])
            {
                nearness[offset + column] = own;
                ids[offset + column] = id;
            }
        }
    }

    /// <summary>
    /// Holds a row's columns to an edge's inner side. A centre exactly on an edge belongs to the triangle on its right,
    /// or below it when the edge is level.
    /// </summary>
    private static bool Narrow(in ScreenLine edge, double y, ref int left, ref int right)
    {
        double atZero = (edge.Y * y) + edge.W;
        if (edge.X == 0)
        {
            return atZero > 0 || (atZero == 0 && edge.Y > 0);
        }

        double crossing = Math.Ceiling((-atZero / edge.X) - 0.5);
        if (edge.X > 0)
        {
            left = crossing > left ? (int)Math.Min(crossing, right) : left;
        }
        else
        {
            right = crossing < right ? (int)Math.Max(crossing, left) : right;
        }

        return left < right;
    }

    private static void DrawDistortedRow(
        in ScreenTriangle triangle, int id, int row, int width, SampleGrid grid, float[] nearness, int[] ids)
    {
        int offset = row * width;
        for (int pixel = offset + triangle.Pixels.Left; pixel < offset + triangle.Pixels.Right; pixel++)
        {
            double x = grid.U[pixel];
            double y = grid.V[pixel];
            if (triangle.Edge0.At(x, y) < 0 || triangle.Edge1.At(x, y) < 0 || triangle.Edge2.At(x, y) < 0)
            {
                continue;
            }

            float own = (float)triangle.Nearness.At(x, y);
            if (own > nearness[pixel])
            {
                nearness[pixel] = own;
                ids[pixel] = id;
            }
        }
    }
}
