namespace Harvester.Geometry.Depth;

/// <summary>
/// Samples the depths of an image, or of a turn of a LiDAR, with few rays: first a coarse grid, then, where the planes of neighbouring hits
/// disagree or part of the mask has no hit, ever finer ones, the largest disagreements first. It can be stopped after any step. See
/// docs/depth.md.
/// </summary>
public sealed class DepthMapper
{
    /// <summary>The most rays that a division takes: the middle and the middles of the sides.</summary>
    private const int RaysOfDivision = 5;

    private readonly DepthGrid _grid;
    private readonly Func<int, int, DepthSample> _sample;
    private readonly int _rayBudget;
    private readonly Dictionary<int, DepthSample> _samples = [];
    private readonly CellJudge _judge;
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
        _judge = new CellJudge(grid, _samples);
        for (int top = 0; top < grid.Size.Height - 1; top += grid.FirstHeight)
        {
            for (int left = 0; left < grid.Size.Width - 1; left += grid.FirstWidth)
            {
                _first.Enqueue(
                    new DepthCell(
                        left,
                        top,
                        Math.Min(left + grid.FirstWidth, grid.Size.Width - 1),
                        Math.Min(top + grid.FirstHeight, grid.Size.Height - 1)
                    )
                );
            }
        }
    }

    /// <summary>The number of rays cast so far.</summary>
    public int RaysCast { get; private set; }

    /// <summary>The samples by the number of their place, row by row.</summary>
    public IReadOnlyDictionary<int, DepthSample> Samples => _samples;

    /// <summary>Uses what another ray has met at a place, instead of a ray of its own.</summary>
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
        DepthCell divided = _divisible[next.Number];
        (int column, int row) = _judge.DivisionOf(divided);
        foreach (DepthCell part in divided.Parts(column, row))
        {
            Judge(part);
        }

        return true;
    }

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

        double weight = _judge.WeightOf(cell);
        if (weight <= 0)
        {
            _settled.Add(cell);
            return;
        }

        // The set is ordered upwards, so the heaviest cell comes first; equal weights go in the order in which they were found.
        _order.Add((-weight, _divisible.Count));
        _divisible.Add(cell);
    }

    private void SampleAt((int Column, int Row) place)
    {
        int at = _grid.At(place.Column, place.Row);
        if (!_samples.ContainsKey(at))
        {
            RaysCast++;
            _samples[at] = _sample(place.Column, place.Row);
        }
    }
}
