using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>The three edges of a triangle side by side: linear functions X·x + Y·y + W over the image that grow inward.</summary>
internal readonly struct EdgeTriple
{
    private readonly Vector256<double> _x;
    private readonly Vector256<double> _y;
    private readonly Vector256<double> _w;

    /// <param name="a">First corner; x and y in pixels.</param>
    /// <param name="b">Second corner, clockwise on the screen.</param>
    /// <param name="c">Third corner.</param>
    public EdgeTriple(Vector256<double> a, Vector256<double> b, Vector256<double> c)
    {
        // Edges of neighbours are the same numbers with opposite signs, to the last bit, so that no pixel falls between them.
        // The first edge stands in the fourth place too, where it changes nothing.
        Vector256<double> fromX = Vector256.Create(a[0], b[0], c[0], a[0]);
        Vector256<double> fromY = Vector256.Create(a[1], b[1], c[1], a[1]);
        Vector256<double> toX = Vector256.Create(b[0], c[0], a[0], b[0]);
        Vector256<double> toY = Vector256.Create(b[1], c[1], a[1], b[1]);

        // Cross product of the edge and the way from its start: X = from.y - to.y, Y = to.x - from.x, W = from × to.
        _x = fromY - toY;
        _y = toX - fromX;
        _w = (fromX * toY) - (fromY * toX);
    }

    /// <summary>The edges' values at a place; an edge's value is 0 on it and positive inside.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<double> At(double x, double y) => (_x * x) + (_y * y) + _w;

    /// <summary>
    /// Limits a row's columns to the inner sides of the edges. A centre exactly on an edge belongs to the triangle on its right, or below
    /// it if the edge is level.
    /// </summary>
    /// <param name="y">The y coordinate of the row's centres, pixels from the top.</param>
    /// <param name="left">The first column to consider.</param>
    /// <param name="right">The column after the last one to consider.</param>
    /// <returns>The columns [Left, Right) within all edges; empty if Left is not less than Right.</returns>
    public (int Left, int Right) ColumnsInside(double y, int left, int right)
    {
        Vector256<double> atZero = (_y * y) + _w;
        Vector256<double> growsRightward = Vector256.GreaterThan(_x, Vector256<double>.Zero);
        Vector256<double> growsLeftward = Vector256.LessThan(_x, Vector256<double>.Zero);
        Vector256<double> isSloped = growsRightward | growsLeftward;
        if (isSloped.ExtractMostSignificantBits() != 0b1111 && IsOutsideLevelEdge(atZero, isSloped))
        {
            return (left, left);
        }

        // The edge is at 0 where x = -(Y y + W) / X; the first column whose centre is not left of it is ⌈x - ½⌉.
        Vector256<double> crossings = Vector256.Ceiling((-atZero / _x) - Vector256.Create(0.5));
        Vector256<double> lefts = Vector256.ConditionalSelect(growsRightward, crossings, Vector256.Create((double)left));
        Vector256<double> rights = Vector256.ConditionalSelect(growsLeftward, crossings, Vector256.Create((double)right));
        Vector128<double> last = Vector128.MaxNative(lefts.GetLower(), lefts.GetUpper());
        Vector128<double> first = Vector128.MinNative(rights.GetLower(), rights.GetUpper());
        return (
            (int)Math.Min(Math.Max(Math.Max(last[0], last[1]), left), right),
            (int)Math.Max(Math.Min(Math.Min(first[0], first[1]), right), left)
        );
    }

    private bool IsOutsideLevelEdge(Vector256<double> atZero, Vector256<double> isSloped)
    {
        Vector256<double> isInside =
            isSloped
            | Vector256.GreaterThan(atZero, Vector256<double>.Zero)
            | (Vector256.Equals(atZero, Vector256<double>.Zero) & Vector256.GreaterThan(_y, Vector256<double>.Zero));
        return isInside.ExtractMostSignificantBits() != 0b1111;
    }
}
