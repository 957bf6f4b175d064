namespace Harvester.Geometry.Paint;

/// <summary>
/// Finds pedestrian crossings in one image: in rows across the road, at least four wide stripes at equal distances; and several such rows
/// behind each other.
/// </summary>
internal sealed class CrossingFinder
{
    /// <summary>Distance of rows, metres: the error with which a crossing's edges are known.</summary>
    public const double RowStep = 0.1;

    /// <summary>Narrowest and widest bar, metres.</summary>
    private const double MinWidth = 0.3;
    private const double MaxWidth = 0.9;

    /// <summary>Cells beside an edge, 10 cm: less than half of the gap between bars.</summary>
    private const int Flank = 4;

    /// <summary>Least and greatest distance of the middles of neighbouring bars, metres.</summary>
    private const double MinPeriod = 0.6;
    private const double MaxPeriod = 2;

    /// <summary>Greatest deviation of a distance from the others, as a fraction.</summary>
    private const double MaxUneven = 0.15;

    /// <summary>Fewest bars of which one row shows that they are a crossing.</summary>
    private const int MinBars = 4;

    /// <summary>Least length of a crossing along the road, metres.</summary>
    private const double MinLength = 1.2;

    /// <summary>Crossings with a greater standard deviation along the road are left out, metres.</summary>
    private const double MaxSigma = 0.5;

    /// <summary>Rows that may be missing between two rows of a crossing.</summary>
    private const int MaxMissing = 2;

    /// <summary>Ground without a bar that must be seen beside the outermost bar, in distances of bars: one more bar, and a half because a
    /// stripe is found only with ground on both sides.</summary>
    private const double PeriodsBeyond = 1.5;

    /// <summary>Ground that must be seen before and behind a crossing, metres.</summary>
    private const double Beyond = 0.4;

    private readonly StripeFinder _finder = new(MinWidth, MaxWidth, Flank);
    private readonly List<StripeFinder.Stripe> _found = [];
    private readonly List<Comb> _combs = [];

    private readonly record struct Comb(int Row, double Left, double Right, double Period, bool IsLeftFree, bool IsRightFree);

    /// <summary>Forgets the rows of an image.</summary>
    public void Clear() => _combs.Clear();

    /// <summary>Adds a part of a row in which every cell is known.</summary>
    /// <param name="row">Number of the row, at least as great as those before.</param>
    /// <param name="profile">Its profile across the road.</param>
    /// <param name="from">Offset of the profile's first cell, metres.</param>
    /// <param name="begin">The first known cell.</param>
    /// <param name="end">The cell after the last known one.</param>
    public void Add(int row, GroundProfile profile, double from, int begin, int end)
    {
        _found.Clear();
        _finder.Find(profile.Bright, profile.Blue, begin, end, _found);
        for (int first = 0; first + MinBars <= _found.Count; first++)
        {
            int last = first + 1;
            double period = MiddleOf(last) - MiddleOf(first);
            if (period is < MinPeriod or > MaxPeriod)
            {
                continue;
            }

            while (last + 1 < _found.Count && Math.Abs(MiddleOf(last + 1) - MiddleOf(last) - period) <= MaxUneven * period)
            {
                last++;
                period = (MiddleOf(last) - MiddleOf(first)) / (last - first);
            }

            if (last - first + 1 >= MinBars)
            {
                double left = _found[first].Left * StripeFinder.Cell;
                double right = _found[last].Right * StripeFinder.Cell;
                bool isLeftFree = left - (begin * StripeFinder.Cell) >= PeriodsBeyond * period;
                bool isRightFree = (end * StripeFinder.Cell) - right >= PeriodsBeyond * period;
                _combs.Add(new Comb(row, from + left, from + right, period, isLeftFree, isRightFree));
                first = last;
            }
        }

        double MiddleOf(int stripe) => (_found[stripe].Left + _found[stripe].Right) / 2 * StripeFinder.Cell;
    }

    /// <summary>The crossings.</summary>
    /// <param name="view">What was seen.</param>
    /// <param name="start">Distance of row 0, metres.</param>
    /// <param name="sigmaAt">Standard deviation at a distance, metres.</param>
    public IEnumerable<SeenMark> Find(MouthView view, double start, Func<double, double> sigmaAt)
    {
        var crossings = new List<List<Comb>>();
        foreach (Comb comb in _combs)
        {
            List<Comb>? crossing = crossings.Find(each => GoesOn(each[each.Count - 1], comb));
            if (crossing is null)
            {
                crossings.Add(crossing = []);
            }

            crossing.Add(comb);
        }

        return crossings
            .Where(static rows => (rows[rows.Count - 1].Row - rows[0].Row + 1) * RowStep >= MinLength)
            .Select(rows => Of(rows, view, start, sigmaAt))
            .Where(static mark => mark.Sigma <= MaxSigma);
    }

    private static bool GoesOn(Comb last, Comb next) =>
        next.Row - last.Row is >= 0 and <= 1 + MaxMissing
        && next.Left <= last.Right
        && last.Left <= next.Right
        && Math.Abs(next.Period - last.Period) <= MaxUneven * last.Period;

    private static SeenMark Of(List<Comb> rows, MouthView view, double start, Func<double, double> sigmaAt)
    {
        double from = start + ((rows[0].Row - 0.5) * RowStep);
        double to = start + ((rows[rows.Count - 1].Row + 0.5) * RowStep);

        // The outermost bar of any row; only in the rows that have it, the ground beside it counts.
        double tolerance = rows[0].Period / 2;
        double outerLeft = rows.Min(static row => row.Left);
        double outerRight = rows.Max(static row => row.Right);
        List<Comb> lefts = rows.FindAll(row => row.Left <= outerLeft + tolerance);
        List<Comb> rights = rows.FindAll(row => row.Right >= outerRight - tolerance);
        double left = WeightedMedian.Of(lefts.ConvertAll(static row => (row.Left, 1.0)));
        double right = WeightedMedian.Of(rights.ConvertAll(static row => (row.Right, 1.0)));
        return new SeenMark(view.Image, MarkKind.Crossing, from, to, left, right, 0, sigmaAt((from + to) / 2))
        {
            IsLeftFree = lefts.Exists(static row => row.IsLeftFree),
            IsRightFree = rights.Exists(static row => row.IsRightFree),
            IsNearFree = IsSeen(view, rows[0], from - Beyond, from),
            IsFarFree = IsSeen(view, rows[rows.Count - 1], to, to + Beyond),
        };
    }

    /// <summary>Whether the ground before or behind all bars of a row was seen.</summary>
    private static bool IsSeen(MouthView view, Comb row, double from, double to)
    {
        for (int column = view.ColumnAt(row.Left); column <= view.ColumnAt(row.Right); column++)
        {
            if (!view.Shows(column, from, to))
            {
                return false;
            }
        }

        return true;
    }
}
