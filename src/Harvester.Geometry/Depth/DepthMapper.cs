using System;
using System.Collections.Generic;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Depth;

/// <summary>
/// Samples the depths of an image with few rays: first a coarse grid, then, where the planes of neighbouring hits disagree or part of the
/// mask has no hit, ever finer ones, the largest disagreements first. It can be stopped after any step. See docs/depth.md.
/// </summary>
public sealed class DepthMapper
{
    /// <summary>Depths that differ by less than this fraction agree.</summary>
    private const double Tolerance = 0.002;

    /// <summary>The most rays that a division takes: the middle and the middles of the sides.</summary>
    private const int RaysOfDivision = 5;

    private readonly DepthGrid _grid;
    private readonly Func<int, int, DepthSample> _sample;
    private readonly int _rayBudget;
    private readonly Dictionary<int, DepthSample> _samples = [];
    private readonly Queue<DepthCell> _first = new();
    private readonly List<DepthCell> _divisible = [];
    private readonly SortedSet<(double Priority, int Number)> _order = [];
    private readonly List<DepthCell> _settled = [];

    /// <summary>Starts a map; no ray is cast before the first <see cref="Step"/>.</summary>
    /// <param name="grid">Where depths are wanted.</param>
    /// <param name="sample">Casts the ray of a place: column, row.</param>
    /// <param name="rayBudget">Maximum number of rays; at least 0.</param>
    /// <exception cref="ArgumentException">The number of regions is not that of the places.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The budget is negative.</exception>
    public DepthMapper(DepthGrid grid, Func<int, int, DepthSample> sample, int rayBudget)
    {
        _grid = Guard.NotNull(grid, nameof(grid));
        if (grid.Regions is { } regions && regions.Length != grid.Size.PixelCount)
        {
            throw new ArgumentException($"There are {regions.Length} regions for {grid.Size.PixelCount} places.", nameof(grid));
        }

        _sample = Guard.NotNull(sample, nameof(sample));
        _rayBudget = Guard.AtLeast(rayBudget, 0, nameof(rayBudget));
        for (int top = 0; top < grid.Size.Height - 1; top += grid.FirstHeight)
        {
            for (int left = 0; left < grid.Size.Width - 1; left += grid.FirstWidth)
            {
                _first.Enqueue(new DepthCell(
                    left, top, Math.Min(left + grid.FirstWidth, grid.Size.Width - 1),
                    Math.Min(top + grid.FirstHeight, grid.Size.Height - 1)));
            }
        }
    }

    /// <summary>The number of rays cast so far.</summary>
    public int RaysCast { get; private set; }

    /// <summary>Uses what another ray has met at the centre of a pixel, instead of a ray of its own.</summary>
    public void Know(int column, int row, DepthSample sample) => _samples[_grid.At(column, row)] = sample;

    /// <summary>Continues with one cell, which takes a handful of rays.</summary>
    /// <returns>False if nothing is left to do or no ray is left.</returns>
    public bool Step()
    {
        if (_rayBudget - RaysCast < RaysOfDivision)
        {
            return false;
        }

        if (_first.Count > 0)
        {
            DepthCell cell = _first.Dequeue();
            if (_grid.SamplesMiddles)
            {
                SampleAt(cell.Middle);
            }

            Judge(cell);
            return true;
        }

        if (_order.Count == 0)
        {
            return false;
        }

        (double Priority, int Number) next = _order.Min;
        _order.Remove(next);
        foreach (DepthCell part in _divisible[next.Number].Parts())
        {
            Judge(part);
        }

        return true;
    }

    /// <summary>The samples by the number of their pixel, row by row.</summary>
    public IReadOnlyDictionary<int, DepthSample> Samples => _samples;

    /// <summary>Completes the map between the samples.</summary>
    public DepthMap Complete()
    {
        var cells = new List<DepthCell>(_settled);
        foreach ((double _, int number) in _order)
        {
            cells.Add(_divisible[number]);
        }

        return new DepthCompletion(_grid, _samples).Complete(cells);
    }

    private void Judge(DepthCell cell)
    {
        foreach ((int Column, int Row) corner in cell.Corners)
        {
            SampleAt(corner);
        }

        double disagreement = cell.Side > _grid.LastSide ? Disagreement(cell) : 0;
        if (disagreement <= Tolerance)
        {
            _settled.Add(cell);
            return;
        }

        double area = (double)(cell.Right - cell.Left) * (cell.Bottom - cell.Top);
        _order.Add((-area * Math.Min(1, disagreement), _divisible.Count));
        _divisible.Add(cell);
    }

    /// <summary>By what fraction the samples in a cell disagree within a region of the mask; 1 if a region has none.</summary>
    private double Disagreement(DepthCell cell)
    {
        (int Column, int Row)[] places = _samples.ContainsKey(At(cell.Middle.Column, cell.Middle.Row))
            ? [.. cell.Corners, cell.Middle] : cell.Corners;
        double greatest = IsCovered(cell, places) ? 0 : 1;
        foreach ((int Column, int Row) place in places)
        {
            DepthSample sample = _samples[At(place.Column, place.Row)];
            SightLine line = _grid.LineOf(place.Column, place.Row);
            foreach ((int Column, int Row) other in places)
            {
                greatest = Math.Max(greatest, Deviation.Of(_samples[At(other.Column, other.Row)], sample, line));
            }
        }

        return greatest;
    }

    private bool IsCovered(DepthCell cell, (int Column, int Row)[] places)
    {
        if (_grid.Regions is null)
        {
            return true;
        }

        ushort last = 0;
        bool isKnown = false;
        for (int row = cell.Top; row <= cell.Bottom; row++)
        {
            for (int column = cell.Left; column <= cell.Right; column++)
            {
                ushort region = _grid.Regions[At(column, row)];
                if (isKnown && region == last)
                {
                    continue;
                }

                if (!Array.Exists(places, place => _samples[At(place.Column, place.Row)].Region == region))
                {
                    return false;
                }

                (last, isKnown) = (region, true);
            }
        }

        return true;
    }

    private void SampleAt((int Column, int Row) place)
    {
        int at = At(place.Column, place.Row);
        if (!_samples.ContainsKey(at) && RaysCast < _rayBudget)
        {
            RaysCast++;
            _samples[at] = _sample(place.Column, place.Row);
        }
    }

    private int At(int column, int row) => _grid.At(column, row);
}
