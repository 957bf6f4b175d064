using System;
using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>The three edges of a triangle side by side, to find what they leave of a row.</summary>
internal readonly struct EdgeTriple
{
    private readonly Vector256<double> _x;
    private readonly Vector256<double> _y;
    private readonly Vector256<double> _w;
    private readonly Vector256<double> _growsRightward;
    private readonly Vector256<double> _growsLeftward;
    private readonly bool _hasLevelEdge;

    public EdgeTriple(in ScreenTriangle triangle)
    {
        // The first edge stands in the fourth place too, where it changes nothing.
        _x = Vector256.Create(triangle.Edge0.X, triangle.Edge1.X, triangle.Edge2.X, triangle.Edge0.X);
        _y = Vector256.Create(triangle.Edge0.Y, triangle.Edge1.Y, triangle.Edge2.Y, triangle.Edge0.Y);
        _w = Vector256.Create(triangle.Edge0.W, triangle.Edge1.W, triangle.Edge2.W, triangle.Edge0.W);
        _growsRightward = Vector256.GreaterThan(_x, Vector256<double>.Zero);
        _growsLeftward = Vector256.LessThan(_x, Vector256<double>.Zero);
        _hasLevelEdge = (_growsRightward | _growsLeftward).ExtractMostSignificantBits() != 0b1111;
    }

    /// <summary>
    /// Holds a row's columns to the edges' inner sides. A centre exactly on an edge belongs to the triangle on its right,
    /// or below it when the edge is level.
    /// </summary>
    /// <param name="y">The height of the row's centres, pixels from the top.</param>
    /// <param name="left">The first column in question.</param>
    /// <param name="right">The column after the last one in question.</param>
    /// <returns>The columns [Left, Right) within all edges; none where Left is not less than Right.</returns>
    public (int Left, int Right) ColumnsInside(double y, int left, int right)
    {
        Vector256<double> atZero = (_y * y) + _w;
        if (_hasLevelEdge && IsOutsideLevelEdge(atZero))
        {
            return (left, left);
        }

        Vector256<double> crossings = Vector256.Ceiling((-atZero / _x) - Vector256.Create(0.5));
        Vector256<double> lefts = Vector256.ConditionalSelect(_growsRightward, crossings, Vector256.Create(double.NegativeInfinity));
        Vector256<double> rights = Vector256.ConditionalSelect(_growsLeftward, crossings, Vector256.Create(double.PositiveInfinity));
        double last = Math.Max(Math.Max(lefts[0], lefts[1]), lefts[2]);
        double first = Math.Min(Math.Min(rights[0], rights[1]), rights[2]);
        return ((int)Math.Clamp(last, left, right), (int)Math.Clamp(first, left, right));
    }

    private bool IsOutsideLevelEdge(Vector256<double> atZero)
    {
        Vector256<double> isInside = _growsRightward | _growsLeftward
            | Vector256.GreaterThan(atZero, Vector256<double>.Zero)
            | (Vector256.Equals(atZero, Vector256<double>.Zero) & Vector256.GreaterThan(_y, Vector256<double>.Zero));
        return isInside.ExtractMostSignificantBits() != 0b1111;
    }
}
