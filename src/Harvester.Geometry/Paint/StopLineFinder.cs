namespace Harvester.Geometry.Paint;

/// <summary>
/// Finds stop lines in one image: bars across the road. Where columns beside each other have a stripe of the same width at the same
/// distance from the junction, and the row of such stripes is long enough and straight, it is a bar.
/// </summary>
internal sealed class StopLineFinder
{
    /// <summary>Narrowest and widest bar along the road, metres: lines are narrower, crossings are wider.</summary>
    private const double MinWidth = 0.2;
    private const double MaxWidth = 0.8;

    /// <summary>Cells beside an edge, 15 cm: at 15 m a pixel shows more than that along the road.</summary>
    private const int Flank = 6;

    /// <summary>Shortest bar across the road, metres: the narrowest lane has 3 m, and a bar may end short of its sides.</summary>
    private const double MinLength = 2;

    /// <summary>Columns that may be missing between two stripes of a bar: worn or hidden.</summary>
    private const int MaxMissing = 2;

    /// <summary>Share of a bar's columns that have a stripe.</summary>
    private const double MinDensity = 0.8;

    /// <summary>Greatest step between the stripes of neighbouring columns, metres: an eighth of it is the slope of a bar, the rest the
    /// error of an edge.</summary>
    private const double MaxStep = 0.15;

    /// <summary>Greatest difference of their widths, metres.</summary>
    private const double MaxWidthStep = 0.2;

    /// <summary>Greatest slope of a bar against the road, metres per metre: a junction that is skewed by 20 degrees.</summary>
    private const double MaxSlope = 0.36;

    /// <summary>
    /// A bar that is no longer than the bars of crossings, metres, and not straight across the road, is one of another road's crossing.
    /// </summary>
    public const double LongestCrossingBar = 4;
    private const double Straight = 0.1;

    /// <summary>Bars that follow each other within this distance are those of another road's crossing, metres.</summary>
    private const double MinApart = 1.6;

    /// <summary>Bars with a greater standard deviation along the road are left out, metres: the width of a bar.</summary>
    private const double MaxSigma = 0.5;

    private readonly StripeFinder _finder = new(MinWidth, MaxWidth, Flank);
    private readonly List<StripeFinder.Stripe> _found = [];
    private readonly List<(int Column, double From, double To)> _stripes = [];

    /// <summary>Forgets the stripes of an image.</summary>
    public void Clear() => _stripes.Clear();

    /// <summary>Adds a part of a column in which every cell is known.</summary>
    /// <param name="column">Number of the column, at least as great as those before.</param>
    /// <param name="profile">Its profile along the road.</param>
    /// <param name="from">Distance of the profile's first cell, metres.</param>
    /// <param name="begin">The first known cell.</param>
    /// <param name="end">The cell after the last known one.</param>
    public void Add(int column, GroundProfile profile, double from, int begin, int end)
    {
        _found.Clear();
        _finder.Find(profile.Bright, profile.Blue, begin, end, _found);
        foreach (StripeFinder.Stripe stripe in _found)
        {
            _stripes.Add((column, from + (stripe.Left * StripeFinder.Cell), from + (stripe.Right * StripeFinder.Cell)));
        }
    }

    /// <summary>The stop lines.</summary>
    /// <param name="view">What was seen.</param>
    /// <param name="sigmaAt">Standard deviation at a distance, metres.</param>
    public IEnumerable<SeenMark> Find(MouthView view, Func<double, double> sigmaAt)
    {
        var bars = new List<List<(int Column, double From, double To)>>();
        foreach ((int Column, double From, double To) stripe in _stripes)
        {
            List<(int Column, double From, double To)>? bar = bars.Find(each => GoesOn(each[each.Count - 1], stripe));
            if (bar is null)
            {
                bars.Add(bar = []);
            }

            bar.Add(stripe);
        }

        List<SeenMark> fitted = [.. bars.Where(IsLongEnough).Select(bar => Fitted(bar, view, sigmaAt))];
        return fitted.Where(mark => IsAcross(mark) && mark.Sigma <= MaxSigma && !fitted.Exists(other => Follows(mark, other)));
    }

    private static bool IsAcross(SeenMark mark) =>
        Math.Abs(mark.Slope) <= (mark.Right - mark.Left > LongestCrossingBar ? MaxSlope : Straight);

    private static bool Follows(SeenMark mark, SeenMark other) =>
        other != mark && Math.Abs(other.Middle - mark.Middle) < MinApart && other.Left < mark.Right && mark.Left < other.Right;

    private static bool GoesOn((int Column, double From, double To) last, (int Column, double From, double To) next) =>
        next.Column > last.Column
        && next.Column - last.Column <= 1 + MaxMissing
        && Math.Abs(next.From + next.To - last.From - last.To) <= 2 * MaxStep
        && Math.Abs(next.To - next.From - last.To + last.From) <= MaxWidthStep;

    private static bool IsLongEnough(List<(int Column, double From, double To)> bar)
    {
        int columns = bar[bar.Count - 1].Column - bar[0].Column + 1;
        return columns * MouthView.ColumnWidth >= MinLength && bar.Count >= MinDensity * columns;
    }

    /// <summary>
    /// The straight line through the middles of the stripes by least squares: slope = Σ (o - o̅) (m - m̅) / Σ (o - o̅)², and the median of
    /// their widths.
    /// </summary>
    private static SeenMark Fitted(List<(int Column, double From, double To)> bar, MouthView view, Func<double, double> sigmaAt)
    {
        int first = bar[0].Column;
        int last = bar[bar.Count - 1].Column;
        double meanOffset = bar.Average(stripe => view.OffsetOf(stripe.Column));
        double mean = bar.Average(stripe => (stripe.From + stripe.To) / 2);
        double products = 0;
        double squares = 0;
        foreach ((int column, double from, double to) in bar)
        {
            double beside = view.OffsetOf(column) - meanOffset;
            products += beside * (((from + to) / 2) - mean);
            squares += beside * beside;
        }

        double slope = products / squares;
        double left = view.OffsetOf(first) - (MouthView.ColumnWidth / 2);
        double right = view.OffsetOf(last) + (MouthView.ColumnWidth / 2);
        double middle = mean + (slope * (((left + right) / 2) - meanOffset));
        double half = WeightedMedian.Of(bar.ConvertAll(static stripe => (stripe.To - stripe.From, 1.0))) / 2;
        return new SeenMark(view.Image, MarkKind.StopLine, middle - half, middle + half, left, right, slope, sigmaAt(middle))
        {
            IsLeftFree = view.Shows(first - 1 - MaxMissing, middle, middle),
            IsRightFree = view.Shows(last + 1 + MaxMissing, middle, middle),
            IsNearFree = true,
            IsFarFree = true,
        };
    }
}
