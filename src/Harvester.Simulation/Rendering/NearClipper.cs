using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>Clips triangles in clip space at the near plane (w = near) and divides by w.</summary>
internal static class NearClipper
{
    private const int DepthElement = 3;

    /// <summary>Returns the number of corners that remain, 0, 3 or 4; x and y are then pixels and z is near / depth.</summary>
    public static int Clip(Vector256<double> a, Vector256<double> b, Vector256<double> c, double near, Span<Vector256<double>> kept)
    {
        double depthA = a[DepthElement];
        double depthB = b[DepthElement];
        double depthC = c[DepthElement];
        if (depthA >= near && depthB >= near && depthC >= near)
        {
            kept[2] = c / depthC;
            kept[1] = b / depthB;
            kept[0] = a / depthA;
            return 3;
        }

        if (depthA < near && depthB < near && depthC < near)
        {
            return 0;
        }

        int count = 0;
        AddEdge(a, b, near, kept, ref count);
        AddEdge(b, c, near, kept, ref count);
        AddEdge(c, a, near, kept, ref count);
        return count < 3 ? 0 : count;
    }

    private static void AddEdge(Vector256<double> from, Vector256<double> to, double near, Span<Vector256<double>> kept, ref int count)
    {
        bool isFromVisible = from[DepthElement] >= near;
        if (isFromVisible)
        {
            kept[count++] = Divided(from);
        }

        if (isFromVisible != to[DepthElement] >= near)
        {
            // Always from the visible end to the hidden one, so that neighbours that share the edge get the same point.
            kept[count++] = Divided(isFromVisible ? Crossing(from, to, near) : Crossing(to, from, near));
        }
    }

    // w is linear along the edge: near is at the fraction (w_visible - near) / (w_visible - w_hidden).
    private static Vector256<double> Crossing(Vector256<double> visible, Vector256<double> hidden, double near) =>
        visible + ((hidden - visible) * ((visible[DepthElement] - near) / (visible[DepthElement] - hidden[DepthElement])));

    private static Vector256<double> Divided(Vector256<double> point) => point / point[DepthElement];
}
