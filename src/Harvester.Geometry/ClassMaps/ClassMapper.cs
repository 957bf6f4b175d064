using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Geometry.ClassMaps;

/// <summary>
/// Maps the classes of all pixels from few rays, in the manner of <see cref="AdaptivePixelMapper"/>: cells are sampled at their corners;
/// where classes change along a border, the place is found by bisection; between two such places the outline is taken to be straight, which
/// two rays confirm; cells that are not confirmed are divided. Rows near the horizon are sampled densely, since upright poles cross them,
/// and scattered samples find what was missed. See docs/pixel-maps.md.
/// </summary>
public sealed class ClassMapper
{
    /// <summary>Side of the first cells, pixels.</summary>
    private const int FirstSide = 32;

    /// <summary>Distance of the samples of a dense row, pixels.</summary>
    private const int RowStep = 3;

    /// <summary>The dense rows: how far above the horizon, as fractions of the image's height.</summary>
    private static readonly double[] RowHeights = [0.005, 0.04, 0.11];

    /// <summary>One pixel in this many is sampled: everywhere by the first search, in cells of several classes by the later ones.</summary>
    private const int FirstSearch = 512;
    private const int LaterSearch = 160;
    private const int MaxSearches = 8;

    /// <summary>How often a first cell is mapped again because of samples that contradict what was drawn.</summary>
    private const int MaxRounds = 6;

    private readonly ClassSamples _samples;
    private readonly ClassCellMapper _mapper;
    private readonly ScatteredRank _rank;
    private readonly List<ClassCell> _first = [];
    private readonly int[] _rounds;
    private readonly int _across;
    private readonly int _horizonRow;
    private readonly Queue<ClassCell> _queue = new();
    private bool _hasRows;
    private int _searches;

    /// <summary>Starts a map; no ray is cast before the first <see cref="Step"/>.</summary>
    /// <param name="image">The image's size, pixels; at least 2 x 2.</param>
    /// <param name="given">The classes that are known, row by row; 0 for pixels to be mapped.</param>
    /// <param name="sample">The class at a pixel's centre, not 0: column, row. Each call is a ray.</param>
    /// <param name="horizonRow">The row of the horizon; it may be outside the image.</param>
    /// <param name="rayBudget">Maximum number of rays; at least 0.</param>
    /// <exception cref="ArgumentException">The number of given classes is not that of the pixels.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The budget is negative.</exception>
    public ClassMapper(ImageSize image, byte[] given, Func<int, int, byte> sample, int horizonRow, int rayBudget)
    {
        if (Guard.NotNull(given, nameof(given)).Length != image.PixelCount)
        {
            throw new ArgumentException($"There are {given.Length} given classes for {image.PixelCount} pixels.", nameof(given));
        }

        _samples = new ClassSamples(image, given, Guard.NotNull(sample, nameof(sample)), Guard.AtLeast(rayBudget, 0, nameof(rayBudget)));
        _mapper = new ClassCellMapper(_samples);
        _rank = new ScatteredRank(image);
        _horizonRow = horizonRow;
        for (int top = 0; top < image.Height - 1; top += FirstSide)
        {
            for (int left = 0; left < image.Width - 1; left += FirstSide)
            {
                _first.Add(
                    new ClassCell(left, top, Math.Min(left + FirstSide, image.Width - 1), Math.Min(top + FirstSide, image.Height - 1))
                );
            }
        }

        _across = (image.Width - 2) / FirstSide + 1;
        _rounds = new int[_first.Count];
        _first.ForEach(_queue.Enqueue);
    }

    /// <summary>The number of rays cast so far.</summary>
    public int RaysCast => _samples.RaysCast;

    /// <summary>Continues with one cell, or one search; a cell takes a few dozen rays at most.</summary>
    /// <returns>False if nothing is left to do or no ray is left.</returns>
    public bool Step()
    {
        if (_samples.IsSpent)
        {
            return false;
        }

        if (!_hasRows)
        {
            _hasRows = true;
            SampleRows();
            return true;
        }

        if (_queue.Count == 0 && !Review())
        {
            return false;
        }

        if (_queue.Count > 0)
        {
            foreach (ClassCell part in _mapper.Map(_queue.Dequeue()))
            {
                _queue.Enqueue(part);
            }
        }

        return true;
    }

    /// <summary>The best map so far; its numbers are the classes.</summary>
    /// <returns>The map, and the number of pixels drawn without a ray.</returns>
    public (InstanceMap Map, int InterpolatedPixels) Finish()
    {
        var map = new InstanceMap(_samples.Image);
        ushort last = 0;
        for (int pass = 0; pass < 2; pass++)
        {
            for (int i = 0; i < map.Ids.Length; i++)
            {
                // Pixels that nothing was drawn at, which only a spent budget leaves, take the last class before them, and those before the
                // first class take that one.
                int at = pass == 0 ? i : map.Ids.Length - 1 - i;
                byte drawn = _samples[at % map.Image.Width, at / map.Image.Width];
                last = drawn != 0 ? drawn : last;
                map.Ids[at] =
                    map.Ids[at] != 0 ? map.Ids[at]
                    : drawn != 0 ? drawn
                    : last;
            }
        }

        return (map, _samples.CountOpen());
    }

    private void SampleRows()
    {
        foreach (double height in RowHeights)
        {
            int row = _horizonRow - (int)Math.Round(height * _samples.Image.Height);
            for (int column = 0; row >= 0 && row < _samples.Image.Height && column < _samples.Image.Width; column += RowStep)
            {
                _samples.At(column, row);
            }
        }
    }

    /// <summary>Has the cells mapped again whose samples contradict what was drawn; without any, searches.</summary>
    private bool Review()
    {
        while (!Reopen())
        {
            if (_searches == MaxSearches || _samples.IsSpent)
            {
                return false;
            }

            _searches++;
            Search();
        }

        return true;
    }

    private bool Reopen()
    {
        var surprised = new SortedSet<int>();
        foreach ((int column, int row) in _samples.Surprises)
        {
            int across = column / FirstSide;
            int down = row / FirstSide;

            // A pixel on the border of first cells belongs to up to four.
            foreach ((int x, int y) in new[] { (across, down), (across - 1, down), (across, down - 1), (across - 1, down - 1) })
            {
                int number = (y * _across) + x;
                if (
                    x >= 0
                    && x < _across
                    && y >= 0
                    && number < _first.Count
                    && _first[number].Contains(column, row)
                    && _rounds[number] < MaxRounds
                )
                {
                    surprised.Add(number);
                }
            }
        }

        _samples.Surprises.Clear();
        foreach (int number in surprised)
        {
            _rounds[number]++;
            _queue.Enqueue(_first[number]);
        }

        return surprised.Count > 0;
    }

    private void Search()
    {
        // Each search takes the next ranks, so that all of them together are scattered evenly.
        double from = _searches == 1 ? 0 : (1.0 / FirstSearch) + ((_searches - 2.0) / LaterSearch);
        double to = _searches == 1 ? 1.0 / FirstSearch : from + (1.0 / LaterSearch);
        foreach (ClassCell cell in _first)
        {
            if (_searches == 1 || IsMixed(cell))
            {
                SearchIn(cell, from, to);
            }
        }

        for (int number = 0; number < _rounds.Length; number++)
        {
            _rounds[number] = 0;
        }
    }

    private void SearchIn(ClassCell cell, double from, double to)
    {
        for (int row = cell.Top; row < cell.Bottom; row++)
        {
            for (int column = cell.Left; column < cell.Right; column++)
            {
                double rank = _rank.Of(column, row);
                if (rank >= from && rank < to)
                {
                    _samples.At(column, row);
                }
            }
        }
    }

    private bool IsMixed(ClassCell cell)
    {
        byte? only = null;
        for (int row = cell.Top; row <= cell.Bottom; row++)
        {
            for (int column = cell.Left; column <= cell.Right; column++)
            {
                if (!_samples.IsGiven(column, row))
                {
                    byte value = _samples[column, row];
                    if (only is { } other && other != value)
                    {
                        return true;
                    }

                    only = value;
                }
            }
        }

        return false;
    }
}
