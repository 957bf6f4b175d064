namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// What is known of a cell's border: the numbers along it and where they change. Between two known pixels of one number, the border is
/// assumed to have that number; between two of different numbers, the change is found by bisection, below the pixel if needed.
/// </summary>
internal sealed class CellBorder
{
    /// <summary>
    /// Minimum length of a side whose middle is assumed instead of sampled: on shorter sides 1 in 10 would be wrong, on longer ones 1 in
    /// 40.
    /// </summary>
    private const int MinAssumedSide = 4;

    private readonly PixelSamples _samples;
    private readonly SilhouetteSpans[] _silhouettes;
    private readonly List<SilhouetteSpans> _near = [];
    private int[] _numbers = [];
    private bool[] _known = [];

    public CellBorder(PixelSamples samples, IReadOnlyList<SilhouetteSpans> silhouettes)
    {
        _samples = samples;
        _silhouettes = [.. silhouettes];
    }

    public MapCell Cell { get; private set; }

    /// <summary>The runs of one number around the border, clockwise; a single one of length 0 if nothing changes.</summary>
    public List<BorderRun> Runs { get; } = [];

    /// <summary>The number assumed for a step of the walk around the border.</summary>
    public int NumberAt(int step) => _numbers[step];

    /// <summary>Reads a cell's border.</summary>
    public void Read(MapCell cell)
    {
        if (Cell != cell)
        {
            Cell = cell;
            _near.Clear();
            foreach (SilhouetteSpans spans in _silhouettes)
            {
                if (spans.BoxMeets(cell))
                {
                    _near.Add(spans);
                }
            }
        }

        int length = cell.BorderLength;
        if (_numbers.Length <= length)
        {
            // The walk along a single row ends a step later, at the pixel where it began.
            _numbers = new int[length + 1];
            _known = new bool[length + 1];
        }

        int step = 0;

        // The walk is clockwise from the upper left corner; each other corner belongs to the side that ends in it.
        for (int column = cell.Left; column <= cell.Right; column++)
        {
            Read(step++, column, cell.Top);
        }

        for (int row = cell.Top + 1; row <= cell.Bottom; row++)
        {
            Read(step++, cell.Right, row);
        }

        for (int column = cell.Right - 1; column >= cell.Left; column--)
        {
            Read(step++, column, cell.Bottom);
        }

        for (int row = cell.Bottom - 1; row > cell.Top; row--)
        {
            Read(step++, cell.Left, row);
        }
    }

    /// <summary>
    /// The next point that the border needs: corners first, then changes of number, then silhouettes that cross it between known pixels.
    /// </summary>
    public SubpixelPoint? Wanted()
    {
        for (int i = 0; i < 4; i++)
        {
            if (!_known[Cell.Corner(i)])
            {
                return PlaceAt(Cell.Corner(i));
            }
        }

        for (int i = 0; i < 4; i++)
        {
            (int from, int to) = (Cell.Corner(i), Cell.Corner(i + 1));
            if ((UndecidedStep(from, to) ?? UnseenSilhouette(from, to)) is { } step)
            {
                return PlaceAt(step);
            }
        }

        return null;
    }

    /// <summary>
    /// Assumes the middle of each side, which becomes a corner of the cell's parts, to have the number known on both sides of it. It is
    /// sampled later if a change of number is found next to it. The runs must have been collected.
    /// </summary>
    public void AssumeMiddles()
    {
        if (Math.Min(Cell.Width, Cell.Height) < MinAssumedSide)
        {
            return;
        }

        foreach (int step in Cell.SideMiddles())
        {
            if (!_known[step])
            {
                (int column, int row) = Cell.Border(step);
                _samples.Assume(column, row, _numbers[step]);
            }
        }
    }

    /// <summary>Fills unknown pixels from the nearest known pixels of the border and collects the runs.</summary>
    public void CollectRuns()
    {
        int length = Cell.BorderLength;
        FillUnknown(length);
        Runs.Clear();
        int first = 0;
        while (first < length && _numbers[first] == _numbers[first == 0 ? length - 1 : first - 1])
        {
            first++;
        }

        if (first == length)
        {
            Runs.Add(new BorderRun(0, length - 1, _numbers[0]));
            return;
        }

        int start = first;
        for (int i = first; i < first + length; i++)
        {
            int number = _numbers[Wrapped(i, length)];
            if (_numbers[Wrapped(i + 1, length)] != number)
            {
                Runs.Add(new BorderRun(start, i, number));
                start = i + 1;
            }
        }
    }

    /// <summary>The next point between the two pixels of a change that narrows it down.</summary>
    public SubpixelPoint? WantedBetween(int step, int halvings)
    {
        (SubpixelPoint place, int halved) = Narrow(step, halvings);
        return halved < halvings ? place : null;
    }

    /// <summary>The position of the change of number after a step, in pixels from the centre of pixel (0, 0).</summary>
    public Vector2D Crossing(int step, int halvings)
    {
        (SubpixelPoint place, _) = Narrow(step, halvings);
        return new Vector2D((double)place.FineX / PixelSamples.Fine, (double)place.FineY / PixelSamples.Fine);
    }

    // The middle of the interval that contains the change, and how often the pixel's step was halved.
    private (SubpixelPoint Middle, int Halved) Narrow(int step, int halvings)
    {
        int length = Cell.BorderLength;
        (int column, int row) = Cell.Border(step % length);
        (int nextColumn, int nextRow) = Cell.Border((step + 1) % length);
        int number = _numbers[step % length];
        int low = 0;
        int high = PixelSamples.Fine;
        for (int halved = 0; ; halved++)
        {
            int middle = (low + high) / 2;
            var place = new SubpixelPoint(
                // The step from one pixel centre to the next is divided into eighths: three halvings at most.
                (column * PixelSamples.Fine) + ((nextColumn - column) * middle),
                (row * PixelSamples.Fine) + ((nextRow - row) * middle)
            );
            if (halved == halvings || _samples.NumberBetween(place) is not { } there)
            {
                return (place, halved);
            }

            (low, high) = there == number ? (middle, high) : (low, middle);
        }
    }

    private void Read(int step, int column, int row)
    {
        int number = _samples.Number(column, row);
        _numbers[step] = number;
        _known[step] = number != PixelSamples.Unknown;
    }

    private int? UndecidedStep(int from, int to)
    {
        int length = Cell.BorderLength;
        int known = from;
        for (int i = from + 1; i <= to; i++)
        {
            int step = Wrapped(i, length);
            if (!_known[step])
            {
                continue;
            }

            if (_numbers[step] != _numbers[Wrapped(known, length)])
            {
                // The change lies between two known pixels: bisection, about log2 of their distance in rays.
                if (i - known > 1)
                {
                    return (known + i) / 2;
                }

                // Next to a change an assumption is no longer safe.
                if (IsAssumed(step) || IsAssumed(known))
                {
                    return IsAssumed(step) ? step : known;
                }
            }

            known = i;
        }

        return null;
    }

    // Of the silhouettes that cross a side between known pixels, the first one is sampled in its middle.
    private int? UnseenSilhouette(int from, int to)
    {
        (int column, int row) = Cell.Border(from);
        (int endColumn, int endRow) = Cell.Border(to % Cell.BorderLength);
        bool alongRow = row == endRow;
        int low = alongRow ? Math.Min(column, endColumn) : Math.Min(row, endRow);
        int high = alongRow ? Math.Max(column, endColumn) : Math.Max(row, endRow);
        (int First, int Last)? best = null;
        foreach (SilhouetteSpans spans in _near)
        {
            (int first, int last) = alongRow ? spans.Row(row) : spans.Column(column);
            first = Math.Max(first, low);
            last = Math.Min(last, high);
            bool comesFirst = best is not { } known || first < known.First || (first == known.First && last < known.Last);
            if (first <= last && comesFirst && !AnyKnown(first, last))
            {
                best = (first, last);
            }
        }

        return best is { } chosen ? from + Math.Abs(((chosen.First + chosen.Last) / 2) - (alongRow ? column : row)) : null;

        bool AnyKnown(int first, int last)
        {
            for (int i = first; i <= last; i++)
            {
                if (_samples.IsKnown(alongRow ? i : column, alongRow ? row : i))
                {
                    return true;
                }
            }

            return false;
        }
    }

    private void FillUnknown(int length)
    {
        int start = 0;
        while (start < length && !_known[start])
        {
            start++;
        }

        if (start == length)
        {
            for (int i = 0; i < length; i++)
            {
                _numbers[i] = 0;
            }

            return;
        }

        int previous = start;
        for (int i = start + 1; i <= start + length; i++)
        {
            if (!_known[Wrapped(i, length)])
            {
                continue;
            }

            // Each unknown pixel between two known ones takes the number of the nearer, the earlier if both are equally near.
            for (int k = previous + 1; k < i; k++)
            {
                _numbers[Wrapped(k, length)] = _numbers[Wrapped(k - previous <= i - k ? previous : i, length)];
            }

            previous = i;
        }
    }

    // A walk has at most two rounds.
    private static int Wrapped(int step, int length) =>
        step < length ? step
        : step < 2 * length ? step - length
        : step - (2 * length);

    private bool IsAssumed(int step)
    {
        (int column, int row) = Cell.Border(step % Cell.BorderLength);
        return _samples.IsAssumed(column, row);
    }

    private SubpixelPoint PlaceAt(int step)
    {
        (int column, int row) = Cell.Border(step % Cell.BorderLength);
        return SubpixelPoint.OfPixel(column, row);
    }
}
