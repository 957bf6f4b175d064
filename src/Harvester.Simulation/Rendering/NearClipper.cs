using System;

namespace Harvester.Simulation.Rendering;

/// <summary>Cuts triangles in clip space at the near plane (w = near) and divides what is left by w.</summary>
internal static class NearClipper
{
    /// <summary>The corners of what is left, 0, 3 or 4; x and y are then pixels and z is near / depth.</summary>
    public static int Clip(Vector4 a, Vector4 b, Vector4 c, double near, Span<Vector4> kept)
    {
        if (a.W >= near && b.W >= near && c.W >= near)
        {
            (kept[0], kept[1], kept[2]) = (Divided(a), Divided(b), Divided(c));
            return 3;
        }

        if (a.W < near && b.W < near && c.W < near)
        {
            return 0;
        }

        int count = 0;
        AddEdge(a, b, near, kept, ref count);
        AddEdge(b, c, near, kept, ref count);
        AddEdge(c, a, near, kept, ref count);
        return count < 3 ? 0 : count;
    }

    private static void AddEdge(Vector4 from, Vector4 to, double near, Span<Vector4> kept, ref int count)
    {
        if (from.W >= near)
        {
            kept[count++] = Divided(from);
        }

        if ((from.W >= near) != (to.W >= near))
        {
            // Always from the visible end to the hidden one, so that neighbours that share the edge get the same point.
            kept[count++] = from.W >= near ? Divided(Crossing(from, to, near)) : Divided(Crossing(to, from, near));
        }
    }

    private static Vector4 Crossing(Vector4 visible, Vector4 hidden, double near) =>
        visible + ((hidden - visible) * ((visible.W - near) / (visible.W - hidden.W)));

    private static Vector4 Divided(Vector4 point) => new(point.X / point.W, point.Y / point.W, point.Z / point.W, 1);
}
