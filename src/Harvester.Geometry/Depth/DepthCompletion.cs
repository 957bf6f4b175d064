using System;
using System.Collections.Generic;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Depth;

/// <summary>
/// Completes a depth map between samples. A pixel takes its depth from the planes of the samples at the corners of its cell that belong to
/// the same region of the mask, so that depth is discontinuous between regions only. Its error is estimated from how far these planes
/// disagree at the pixel, and how far they disagree with the neighbouring hits. A pixel without such a corner takes the sample of its
/// region that is nearest within the region.
/// </summary>
internal sealed class DepthCompletion(
    ImageSize image, ushort[]? regions, IReadOnlyDictionary<int, DepthSample> samples, Func<int, int, Vector3D> directionOf)
{
    /// <summary>The error of a depth that only a sample elsewhere in the region supports, as a fraction of it.</summary>
    private const double ErrorOfDistantSample = 0.05;

    /// <summary>A plane that is extended to more than this multiple of its sample's depth, or less than its inverse, is not.</summary>
    private const double MaxExtension = 3;

    private readonly DepthMap _map = new(image);
    private readonly Dictionary<int, double> _residuals = [];
    private readonly DepthSample[] _near = new DepthSample[4];
    private readonly double[] _weights = new double[4];

    public DepthMap Complete(IReadOnlyList<DepthCell> cells)
    {
        for (int i = 0; i < _map.Metres.Length; i++)
        {
            _map.Metres[i] = double.NaN;
        }

        foreach (DepthCell cell in cells)
        {
            FindResiduals(cell);
        }

        foreach (DepthCell cell in cells)
        {
            Fill(cell);
        }

        foreach (KeyValuePair<int, DepthSample> sample in samples)
        {
            if (RegionAt(sample.Key) == sample.Value.Region)
            {
                (_map.Metres[sample.Key], _map.ErrorMetres[sample.Key]) = (sample.Value.Depth, 0);
            }
        }

        Spread();
        return _map;
    }

    private void FindResiduals(DepthCell cell)
    {
        (int Column, int Row)[] corners = cell.Corners;
        foreach ((int column, int row) in corners)
        {
            int at = At(column, row);
            if (!samples.TryGetValue(at, out DepthSample sample) || !sample.IsHit)
            {
                continue;
            }

            Vector3D direction = directionOf(column, row);
            _residuals.TryGetValue(at, out double residual);
            foreach ((int otherColumn, int otherRow) in corners)
            {
                if (samples.TryGetValue(At(otherColumn, otherRow), out DepthSample other) && other.IsHit && other.Entity == sample.Entity)
                {
                    residual = Math.Max(residual, Deviation.Of(other, sample, direction));
                }
            }

            _residuals[at] = residual;
        }
    }

    private void Fill(DepthCell cell)
    {
        double width = Math.Max(1, cell.Right - cell.Left);
        double height = Math.Max(1, cell.Bottom - cell.Top);
        (int Column, int Row)[] corners = cell.Corners;
        for (int row = cell.Top; row <= cell.Bottom; row++)
        {
            for (int column = cell.Left; column <= cell.Right; column++)
            {
                int at = At(column, row);
                double right = (column - cell.Left) / width;
                double down = (row - cell.Top) / height;
                int count = 0;
                double residual = 0;
                for (int corner = 0; corner < corners.Length; corner++)
                {
                    int where = At(corners[corner].Column, corners[corner].Row);
                    if (samples.TryGetValue(where, out DepthSample sample) && sample.Region == RegionAt(at))
                    {
                        _near[count] = sample;
                        _weights[count] = ((corner & 1) == 0 ? 1 - right : right) * (corner < 2 ? 1 - down : down);
                        _residuals.TryGetValue(where, out double known);
                        residual = Math.Max(residual, known);
                        count++;
                    }
                }

                if (count > 0)
                {
                    Estimate(at, directionOf(column, row), count, residual);
                }
            }
        }
    }

    private void Estimate(int at, Vector3D direction, int count, double residual)
    {
        int nearest = 0;
        for (int i = 1; i < count; i++)
        {
            nearest = _weights[i] > _weights[nearest] ? i : nearest;
        }

        if (!_near[nearest].IsHit)
        {
            _map.Metres[at] = double.PositiveInfinity;
            return;
        }

        // Surfaces that are one: their planes are averaged, so that curved ones are smooth. Otherwise the nearest sample decides.
        double sum = 0;
        double weights = 0;
        for (int i = 0; i < count; i++)
        {
            if (_near[i].IsHit && _near[i].Entity == _near[nearest].Entity)
            {
                sum += _weights[i] * InverseOf(_near[i], direction);
                weights += _weights[i];
            }
        }

        bool isOne = residual <= SmoothResidual && weights > 0;
        double depth = 1 / (isOne ? sum / weights : InverseOf(_near[nearest], direction));
        double error = residual * depth;
        for (int i = 0; i < count; i++)
        {
            error = Math.Max(error, _near[i].IsHit ? Math.Abs((1 / InverseOf(_near[i], direction)) - depth) : depth);
        }

        (_map.Metres[at], _map.ErrorMetres[at]) = (depth, error);
    }

    /// <summary>Samples whose planes foretell each other to this fraction of the depth are taken to be of one surface.</summary>
    private const double SmoothResidual = 0.05;

    private static double InverseOf(DepthSample sample, Vector3D direction)
    {
        double inverse = sample.Surface.InverseAt(direction);
        double own = 1 / sample.Depth;
        return inverse >= own / MaxExtension && inverse <= own * MaxExtension ? inverse : own;
    }

    /// <summary>Gives pixels without a depth that of the nearest sample of their region, along paths within the region.</summary>
    private void Spread()
    {
        var origin = new int[_map.Metres.Length];
        var queue = new Queue<int>();
        foreach (KeyValuePair<int, DepthSample> sample in samples)
        {
            if (RegionAt(sample.Key) == sample.Value.Region)
            {
                origin[sample.Key] = sample.Key + 1;
                queue.Enqueue(sample.Key);
            }
        }

        while (queue.Count > 0)
        {
            int at = queue.Dequeue();
            int column = at % image.Width;
            Visit(at, column > 0, -1);
            Visit(at, column + 1 < image.Width, 1);
            Visit(at, at >= image.Width, -image.Width);
            Visit(at, at + image.Width < origin.Length, image.Width);
        }

        void Visit(int from, bool isInside, int step)
        {
            int at = from + step;
            if (!isInside || origin[at] != 0 || RegionAt(at) != RegionAt(from))
            {
                return;
            }

            origin[at] = origin[from];
            queue.Enqueue(at);
            if (double.IsNaN(_map.Metres[at]))
            {
                DepthSample sample = samples[origin[from] - 1];
                double depth = sample.IsHit ? 1 / InverseOf(sample, directionOf(at % image.Width, at / image.Width)) : sample.Depth;
                (_map.Metres[at], _map.ErrorMetres[at]) =
                    (depth, sample.IsHit ? Math.Max(Math.Abs(depth - sample.Depth), ErrorOfDistantSample * depth) : 0);
            }
        }
    }

    private int At(int column, int row) => (row * image.Width) + column;

    private ushort RegionAt(int at) => regions?[at] ?? 0;
}
