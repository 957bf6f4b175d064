using System;
using System.Collections.Generic;

namespace Harvester.Capture.Spaces.Survey;

/// <summary>Depths of a model over a grid of rays along its y axis, seen from behind (from -y). Cells are squares; row 0 is the lowest.</summary>
internal sealed class DepthGrid
{
    private readonly double _left;
    private readonly double _bottom;
    private readonly double?[,] _depths;

    /// <summary>Makes an empty grid over a rectangle.</summary>
    public DepthGrid(double left, double bottom, double right, double top, double step)
    {
        _left = left;
        _bottom = bottom;
        Step = step;
        Columns = Math.Max(1, (int)Math.Ceiling((right - left) / step));
        Rows = Math.Max(1, (int)Math.Ceiling((top - bottom) / step));
        _depths = new double?[Columns, Rows];
    }

    public double Step { get; }

    public int Columns { get; }

    public int Rows { get; }

    public double? this[int column, int row] => _depths[column, row];

    public double XOf(double column) => _left + (column * Step);

    public double ZOf(double row) => _bottom + (row * Step);

    /// <summary>Casts the rays, one an element.</summary>
    public IEnumerable<bool> Fill(StageProbe probe)
    {
        for (int row = 0; row < Rows; row++)
        {
            for (int column = 0; column < Columns; column++)
            {
                _depths[column, row] = probe.FromBehind(XOf(column + 0.5), ZOf(row + 0.5));
                yield return true;
            }
        }
    }

    /// <summary>Cells of a row that met the model.</summary>
    public int Width(int row)
    {
        int width = 0;
        for (int column = 0; column < Columns; column++)
        {
            width += _depths[column, row] is null ? 0 : 1;
        }

        return width;
    }

    /// <summary>The middle one of a row's depths; null for an empty row.</summary>
    public double? MedianDepth(int row)
    {
        var depths = new List<double>();
        for (int column = 0; column < Columns; column++)
        {
            if (_depths[column, row] is { } depth)
            {
                depths.Add(depth);
            }
        }

        depths.Sort();
        return depths.Count == 0 ? null : depths[depths.Count / 2];
    }

    /// <summary>The first and last column of a row whose depth is near a plane; null when none is.</summary>
    public (int First, int Last)? Near(int row, double plane, double tolerance)
    {
        int? first = null;
        int last = 0;
        for (int column = 0; column < Columns; column++)
        {
            if (_depths[column, row] is { } depth && Math.Abs(depth - plane) <= tolerance)
            {
                first ??= column;
                last = column;
            }
        }

        return first is { } found ? (found, last) : null;
    }
}
