namespace Harvester.Geometry.Paint;

/// <summary>
/// Finds arrows in one image. In rows across the road, an arrow is a narrow stripe, its shaft, that becomes wide towards the junction, its
/// head, and ends there. A head that reaches as far to both sides points straight on, otherwise to the side to which it reaches.
/// </summary>
internal sealed class ArrowFinder
{
    /// <summary>Narrowest and widest row of an arrow, metres.</summary>
    private const double MinWidth = 0.1;
    private const double MaxWidth = 1.6;

    /// <summary>Cells beside an edge, 10 cm.</summary>
    private const int Flank = 4;

    /// <summary>Widest shaft, metres.</summary>
    private const double MaxShaft = 0.35;

    /// <summary>Least and greatest length of a shaft, metres.</summary>
    private const double MinShaftLength = 0.8;
    private const double MaxShaftLength = 6;

    /// <summary>Least and greatest length of a head along the road, metres: bars of crossings are longer.</summary>
    private const double MinHeadLength = 0.3;
    private const double MaxHeadLength = 1.8;

    /// <summary>A row of the head is at least this many times as wide as the shaft.</summary>
    private const double MinWidening = 1.8;

    /// <summary>The tip of a head is at most this part of its greatest width: an arrow begins narrow, a bar does not.</summary>
    private const double MaxTip = 0.7;

    /// <summary>How far a head reaches from the middle of the shaft, straight on and to a side, metres.</summary>
    private const double MinReach = 0.25;
    private const double MinSideReach = 0.5;

    /// <summary>A head points to a side if it reaches this many times as far to it as to the other.</summary>
    private const double MinOneSided = 2;

    /// <summary>The middles of the rows of a shaft follow each other within this, metres: its slant, and the error of an edge.</summary>
    private const double MaxShaftStep = 0.06;

    /// <summary>Rows that may be missing between two rows of an arrow.</summary>
    private const int MaxMissing = 2;

    /// <summary>Ground without paint of the arrow that must be seen before its tip and behind its shaft, metres.</summary>
    private const double Beyond = 0.4;

    /// <summary>Arrows with a greater standard deviation along the road are left out, metres.</summary>
    private const double MaxSigma = 0.5;

    private readonly StripeFinder _finder = new(MinWidth, MaxWidth, Flank);
    private readonly List<StripeFinder.Stripe> _found = [];
    private readonly List<List<Slice>> _chains = [];

    /// <summary>The chains that the next row may continue, in the order of all.</summary>
    private readonly List<List<Slice>> _open = [];

    private readonly record struct Slice(int Row, double Left, double Right)
    {
        public double Middle => (Left + Right) / 2;

        public double Width => Right - Left;
    }

    /// <summary>Forgets the rows of an image.</summary>
    public void Clear()
    {
        _chains.Clear();
        _open.Clear();
    }

    /// <summary>Adds a part of a row in which every cell is known.</summary>
    /// <param name="row">Number of the row, at least as great as those before; rows lead away from the junction.</param>
    /// <param name="profile">Its profile across the road.</param>
    /// <param name="from">Offset of the profile's first cell, metres.</param>
    /// <param name="begin">The first known cell.</param>
    /// <param name="end">The cell after the last known one.</param>
    public void Add(int row, GroundProfile profile, double from, int begin, int end)
    {
        _found.Clear();
        _open.RemoveAll(chain => row - chain[chain.Count - 1].Row > 1 + MaxMissing);
        _finder.Find(profile.Bright, profile.Blue, begin, end, _found);
        foreach (StripeFinder.Stripe stripe in _found)
        {
            var slice = new Slice(row, from + (stripe.Left * StripeFinder.Cell), from + (stripe.Right * StripeFinder.Cell));
            List<Slice>? chain = _open.Find(each => GoesOn(each[each.Count - 1], slice));
            if (chain is null)
            {
                _chains.Add(chain = []);
                _open.Add(chain);
            }

            chain.Add(slice);
        }
    }

    /// <summary>The arrows.</summary>
    /// <param name="view">What was seen.</param>
    /// <param name="start">Distance of row 0, metres.</param>
    /// <param name="sigmaAt">Standard deviation at a distance, metres.</param>
    public IEnumerable<SeenMark> Find(MouthView view, double start, Func<double, double> sigmaAt) =>
        _chains.Select(chain => Of(chain, view, start, sigmaAt)).OfType<SeenMark>().Where(static mark => mark.Sigma <= MaxSigma);

    private static bool GoesOn(Slice last, Slice next) =>
        next.Row - last.Row is > 0 and <= 1 + MaxMissing && next.Left <= last.Right && last.Left <= next.Right;

    private static SeenMark? Of(List<Slice> chain, MouthView view, double start, Func<double, double> sigmaAt)
    {
        // The shaft: from the far end, rows of one narrow width whose middles follow each other.
        int first = chain.Count - 1;
        while (first > 0 && IsShaft(chain[first - 1]) && Math.Abs(chain[first - 1].Middle - chain[first].Middle) <= MaxShaftStep)
        {
            first--;
        }

        List<Slice> shaft = chain.GetRange(first, chain.Count - first);
        List<Slice> head = chain.GetRange(0, first);
        double width = WeightedMedian.Of(shaft.ConvertAll(static slice => (slice.Width, 1.0)));
        double middle = WeightedMedian.Of(shaft.ConvertAll(static slice => (slice.Middle, 1.0)));
        if (!IsShaft(shaft[shaft.Count - 1]) || Length(shaft) is < MinShaftLength or > MaxShaftLength || head.Count == 0)
        {
            return null;
        }

        List<Slice> wide = head.FindAll(slice => slice.Width >= MinWidening * width);
        if (wide.Count == 0 || Length(wide) < MinHeadLength || Length(head) > MaxHeadLength)
        {
            return null;
        }

        double left = middle - wide.Min(static slice => slice.Left);
        double right = wide.Max(static slice => slice.Right) - middle;
        double near = start + ((chain[0].Row - 0.5) * CrossingFinder.RowStep);
        double far = start + ((chain[chain.Count - 1].Row + 0.5) * CrossingFinder.RowStep);
        if (!view.Shows(view.ColumnAt(middle), near - Beyond, near) || !view.Shows(view.ColumnAt(middle), far, far + Beyond))
        {
            return null;
        }

        // Who drives towards the junction looks against the rows: the road's right is the driver's left.
        MarkKind kind =
            left >= MinOneSided * right ? MarkKind.ArrowRight
            : right >= MinOneSided * left ? MarkKind.ArrowLeft
            : MarkKind.ArrowStraight;
        bool isPointed = chain[0].Width <= MaxTip * wide.Max(static slice => slice.Width);
        double reach = kind == MarkKind.ArrowStraight ? Math.Min(left, right) - MinReach : Math.Max(left, right) - MinSideReach;
        if (reach < 0 || !isPointed)
        {
            return null;
        }

        return new SeenMark(view.Image, kind, near, far, middle - left, middle + right, 0, sigmaAt((near + far) / 2))
        {
            IsLeftFree = true,
            IsRightFree = true,
            IsNearFree = true,
            IsFarFree = true,
        };
    }

    private static bool IsShaft(Slice slice) => slice.Width <= MaxShaft;

    private static double Length(List<Slice> rows) => (rows[rows.Count - 1].Row - rows[0].Row + 1) * CrossingFinder.RowStep;
}
