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
    /// <summary>Side of the first cells, pixels.</summary>
    private const int FirstSide = 16;

    /// <summary>Cells of this side are not divided, pixels.</summary>
    private const int LastSide = 2;

    /// <summary>Depths that differ by less than this fraction agree.</summary>
    private const double Tolerance = 0.002;

    /// <summary>The most rays that a division takes: the middle and the middles of the sides.</summary>
    private const int RaysOfDivision = 5;

    private readonly ImageSize _image;
    private readonly ushort[]? _regions;
    private readonly Func<int, int, DepthSample> _sample;
    private readonly Func<int, int, Vector3D> _directionOf;
    private readonly int _rayBudget;
    private readonly Dictionary<int, DepthSample> _samples = [];
    private readonly Queue<DepthCell> _first = new();
    private readonly List<DepthCell> _divisible = [];
    private readonly SortedSet<(double Priority, int Number)> _order = [];
    private readonly List<DepthCell> _settled = [];

    /// <summary>Starts a map; no ray is cast before the first <see cref="Step"/>.</summary>
    /// <param name="image">The image's size, pixels; at least 2 x 2.</param>
    /// <param name="regions">The mask's number at each pixel, row by row; null without a mask.</param>
    /// <param name="sample">Casts a ray through the centre of a pixel: column, row.</param>
    /// <param name="directionOf">The direction to the centre of a pixel in the camera's frame, 1 along its axis: column, row.</param>
    /// <param name="rayBudget">Maximum number of rays; at least 0.</param>
    /// <exception cref="ArgumentException">The number of regions is not that of the pixels.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The budget is negative.</exception>
    public DepthMapper(
        ImageSize image, ushort[]? regions, Func<int, int, DepthSample> sample, Func<int, int, Vector3D> directionOf, int rayBudget)
    {
        if (regions is not null && regions.Length != image.PixelCount)
        {
            throw new ArgumentException($"There are {regions.Length} regions for {image.PixelCount} pixels.", nameof(regions));
        }

        _image = image;
        _regions = regions;
        _sample = Guard.NotNull(sample, nameof(sample));
        _directionOf = Guard.NotNull(directionOf, nameof(directionOf));
        _rayBudget = Guard.AtLeast(rayBudget, 0, nameof(rayBudget));
        for (int top = 0; top < image.Height - 1; top += FirstSide)
        {
            for (int left = 0; left < image.Width - 1; left += FirstSide)
            {
                _first.Enqueue(new DepthCell(
                    left, top, Math.Min(left + FirstSide, image.Width - 1), Math.Min(top + FirstSide, image.Height - 1)));
            }
        }
    }

    /// <summary>The number of rays cast so far.</summary>
    public int RaysCast { get; private set; }

    /// <summary>Uses what another ray has met at the centre of a pixel, instead of a ray of its own.</summary>
    public void Know(int column, int row, DepthSample sample) => _samples[At(column, row)] = sample;

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
            SampleAt(cell.Middle);
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

        return new DepthCompletion(_image, _regions, _samples, _directionOf).Complete(cells);
    }

    private void Judge(DepthCell cell)
    {
        foreach ((int Column, int Row) corner in cell.Corners)
        {
            SampleAt(corner);
        }

        double disagreement = cell.Side > LastSide ? Disagreement(cell) : 0;
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
            Vector3D direction = _directionOf(place.Column, place.Row);
            foreach ((int Column, int Row) other in places)
            {
                greatest = Math.Max(greatest, Deviation.Of(_samples[At(other.Column, other.Row)], sample, direction));
            }
        }

        return greatest;
    }

    private bool IsCovered(DepthCell cell, (int Column, int Row)[] places)
    {
        if (_regions is null)
        {
            return true;
        }

        ushort last = 0;
        bool isKnown = false;
        for (int row = cell.Top; row <= cell.Bottom; row++)
        {
            for (int column = cell.Left; column <= cell.Right; column++)
            {
                ushort region = _regions[At(column, row)];
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

    private int At(int column, int row) => (row * _image.Width) + column;
}
