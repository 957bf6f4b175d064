namespace Harvester.Geometry.Depth;

/// <summary>
/// Completes a depth map between samples. A place takes its depth from the planes of the samples at the corners of its cell that belong to
/// the same region of the mask, so that depth is discontinuous between regions only. Its error is estimated from how far these planes
/// disagree at the place, and how far they disagree with the neighbouring hits. A place without such a corner takes the sample of its
/// region that is nearest within the region.
/// </summary>
internal sealed class DepthCompletion(DepthGrid grid, IReadOnlyDictionary<int, DepthSample> samples)
{
    /// <summary>The error of a depth that only a sample elsewhere in the region supports, as a fraction of it; an estimate.</summary>
    private const double ErrorOfDistantSample = 0.05;

    private readonly DepthMap _map = new(grid.Size);
    private readonly Dictionary<int, double> _residuals = [];
    private readonly CellSurfaces _surfaces = new();

    public DepthMap Complete(IReadOnlyList<DepthCell> cells)
    {
        for (int i = 0; i < _map.Metres.Length; i++)
        {
            (_map.Metres[i], _map.Sources[i]) = (double.NaN, -1);
        }

        foreach (DepthCell cell in cells)
        {
            // How far the planes of neighbouring hits of one entity fail to predict a sample is its residual, the largest over all its
            // cells.
            FindResiduals(cell);
        }

        foreach (DepthCell cell in cells)
        {
            Fill(cell);
        }

        // Samples stand as they are, over what their cells predict for them.
        foreach (KeyValuePair<int, DepthSample> sample in samples)
        {
            if (grid.RegionAt(sample.Key) == sample.Value.Region)
            {
                Set(sample.Key, sample.Value.Depth, 0, sample.Key);
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
            int at = grid.At(column, row);
            if (!samples.TryGetValue(at, out DepthSample sample) || !sample.IsHit)
            {
                continue;
            }

            SightLine line = grid.LineOf(column, row);
            _residuals.TryGetValue(at, out double residual);
            foreach ((int otherColumn, int otherRow) in corners)
            {
                if (
                    samples.TryGetValue(grid.At(otherColumn, otherRow), out DepthSample other)
                    && other.IsHit
                    && other.Entity == sample.Entity
                )
                {
                    residual = Math.Max(residual, Deviation.Of(other, sample, line));
                }
            }

            _residuals[at] = residual;
        }
    }

    private void Fill(DepthCell cell)
    {
        (int Column, int Row)[] corners = cell.Corners;
        ushort? region = null;
        for (int row = cell.Top; row <= cell.Bottom; row++)
        {
            for (int column = cell.Left; column <= cell.Right; column++)
            {
                int at = grid.At(column, row);
                if (region != grid.RegionAt(at))
                {
                    region = grid.RegionAt(at);
                    _surfaces.Begin(cell);
                    for (int corner = 0; corner < corners.Length; corner++)
                    {
                        int where = grid.At(corners[corner].Column, corners[corner].Row);
                        if (samples.TryGetValue(where, out DepthSample sample) && sample.Region == region)
                        {
                            _residuals.TryGetValue(where, out double residual);
                            _surfaces.Add(corner, where, sample, residual, grid.LineAt(where));
                        }
                    }

                    _surfaces.Understand();
                }

                if (_surfaces.DepthAt(column, row, grid.LineOf(column, row)) is { } found)
                {
                    Set(at, found.Depth, found.Error, found.Source);
                }
            }
        }
    }

    /// <summary>Gives places without a depth that of the nearest sample of their region, along paths within the region.</summary>
    private void Spread()
    {
        var queue = new Queue<int>();
        var origin = new int[_map.Metres.Length];
        foreach (KeyValuePair<int, DepthSample> sample in samples)
        {
            if (grid.RegionAt(sample.Key) == sample.Value.Region)
            {
                origin[sample.Key] = sample.Key + 1;
                queue.Enqueue(sample.Key);
            }
        }

        int width = grid.Size.Width;

        // Breadth-first from all samples at once: each place is reached first from the sample of its region that is nearest along rows and
        // columns.
        while (queue.Count > 0)
        {
            int at = queue.Dequeue();
            int column = at % width;
            Visit(at, column > 0, -1);
            Visit(at, column + 1 < width, 1);
            Visit(at, at >= width, -width);
            Visit(at, at + width < origin.Length, width);
        }

        void Visit(int from, bool isInside, int step)
        {
            int at = from + step;
            if (!isInside || origin[at] != 0 || grid.RegionAt(at) != grid.RegionAt(from))
            {
                return;
            }

            origin[at] = origin[from];
            queue.Enqueue(at);
            if (double.IsNaN(_map.Metres[at]))
            {
                DepthSample sample = samples[origin[from] - 1];

                // The sample's plane is extended to the place; the error is what this changes, or the fraction for distant samples if that
                // is more.
                double depth = sample.IsHit ? 1 / CellSurfaces.InverseOf(sample, grid.LineAt(at)) : sample.Depth;
                double error = sample.IsHit ? Math.Max(Math.Abs(depth - sample.Depth), ErrorOfDistantSample * depth) : 0;
                Set(at, depth, error, origin[from] - 1);
            }
        }
    }

    private void Set(int at, double depth, double error, int source) =>
        (_map.Metres[at], _map.ErrorMetres[at], _map.Sources[at]) = (depth, error, source);
}
