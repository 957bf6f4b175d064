namespace Harvester.Geometry.Paint;

/// <summary>
/// Finds bright stripes in the brightness along a line on the road. A stripe has a rising and a falling edge of similar strength, a known
/// distance apart, with darker ground on both sides: a shadow, a kerb or the border of the asphalt has one edge, a crack is dark, a tyre
/// mark is wide.
/// </summary>
/// <param name="minWidth">Narrowest stripe, metres.</param>
/// <param name="maxWidth">Widest stripe, metres.</param>
/// <param name="flank">Cells on each side of an edge whose means are compared; no more than the stripes' distance.</param>
internal sealed class StripeFinder(double minWidth, double maxWidth, int flank)
{
    /// <summary>Width of a cell of the profile, metres: a quarter of the narrowest paint.</summary>
    public const double Cell = 0.025;

    /// <summary>Narrowest and widest painted line, metres: paint is 8 to 30 cm wide, the bars of a crossing 40 cm and more.</summary>
    private const double MinLine = 0.06;
    private const double MaxLine = 0.36;

    /// <summary>Cells beside an edge of a line: 7.5 cm, narrower than the gap of a double line.</summary>
    private const int LineFlank = 3;

    /// <summary>An edge is this many standard deviations of the texture strong.</summary>
    private const double MinEdgeOverNoise = 3;

    /// <summary>Least strength of an edge as a fraction of the brightness: worn paint is about a quarter brighter than asphalt.</summary>
    private const double MinRelativeEdge = 0.12;

    /// <summary>Least strength of an edge in grey levels: twice the quantisation and compression of dark images.</summary>
    private const double MinEdge = 4;

    /// <summary>The weaker edge is at least this fraction of the stronger.</summary>
    private const double MinEdgeBalance = 0.4;

    /// <summary>Least contrast of a stripe as a fraction of the brightness beside it.</summary>
    private const double MinContrast = 0.2;

    /// <summary>Factor from the median of absolute values of normal noise to its standard deviation.</summary>
    private const double MedianToSigma = 1.4826;

    private readonly int[] _histogram = new int[256];
    private double[] _edges = [];

    /// <summary>A finder of painted lines.</summary>
    public static StripeFinder OfLines() => new(MinLine, MaxLine, LineFlank);

    /// <summary>A stripe: its edges in cells from the profile's first, its contrast and its blueness.</summary>
    public readonly record struct Stripe(double Left, double Right, double Contrast, double Blueness);

    /// <summary>Finds the stripes in a part of a profile in which every cell is known.</summary>
    /// <param name="bright">Mean of red and green, per cell.</param>
    /// <param name="blue">Blue, per cell.</param>
    /// <param name="from">First cell.</param>
    /// <param name="to">The cell after the last.</param>
    /// <param name="found">Receives the stripes.</param>
    public void Find(float[] bright, float[] blue, int from, int to, List<Stripe> found)
    {
        if (to - from < 4 * flank)
        {
            return;
        }

        if (_edges.Length < bright.Length + 1)
        {
            _edges = new double[bright.Length + 1];
        }

        // Edge strength between two cells: g(i) = mean of the cells i to i + F - 1 - mean of the cells i - F to i - 1, with F = flank.
        double noise = Edges(bright, from, to);
        double level = Mean(bright, from, to);
        double least = Math.Max(MinEdge, Math.Max(MinEdgeOverNoise * noise, MinRelativeEdge * level));
        int last = to - flank - 1;
        for (int rise = from + flank + 1; rise <= last; rise++)
        {
            if (_edges[rise] < least || !IsPeak(rise, 1))
            {
                continue;
            }

            // Edges within the stripe that are much weaker than its own are wear.
            double strong = Math.Max(least, MinEdgeBalance * _edges[rise]);
            for (int fall = rise + 1; fall <= Math.Min(last, rise + (int)(maxWidth / Cell) + 1); fall++)
            {
                if (_edges[fall] >= strong && IsPeak(fall, 1))
                {
                    break;
                }

                if (_edges[fall] <= -strong && IsPeak(fall, -1))
                {
                    AddIfPaint(bright, blue, from, to, rise, fall, found);
                    break;
                }
            }
        }
    }

    private void AddIfPaint(float[] bright, float[] blue, int from, int to, int rise, int fall, List<Stripe> found)
    {
        double left = SubCell(rise);
        double right = SubCell(fall);
        double width = (right - left) * Cell;
        double balance = _edges[rise] / -_edges[fall];
        if (width < minWidth || width > maxWidth || balance < MinEdgeBalance || balance > 1 / MinEdgeBalance)
        {
            return;
        }

        // The outermost cells of a stripe and of its flanks are blurred into each other and left out where there are others.
        int trim = fall - rise > 2 ? 1 : 0;
        double inside = Mean(bright, rise + trim, fall - trim);
        int before = Math.Max(from, rise - 1 - flank);
        int after = Math.Min(to, fall + 1 + flank);
        double leftLevel = Mean(bright, before, rise - 1);
        double rightLevel = Mean(bright, fall + 1, after);
        double outside = Math.Max(leftLevel, rightLevel);
        double contrast = (inside - outside) / Math.Max(1, outside);
        if (contrast >= MinContrast)
        {
            double asphalt = (Mean(blue, before, rise - 1) + Mean(blue, fall + 1, after)) / Math.Max(1, leftLevel + rightLevel);
            double paint = Mean(blue, rise + trim, fall - trim) / Math.Max(1, inside);
            found.Add(new Stripe(left, right, contrast, paint / Math.Max(0.1, asphalt)));
        }
    }

    /// <summary>Computes the edge strengths and the standard deviation of the texture, from the median of their absolute values.</summary>
    private double Edges(float[] bright, int from, int to)
    {
        Array.Clear(_histogram, 0, _histogram.Length);
        double below = 0;
        double above = 0;
        for (int i = from; i < from + flank; i++)
        {
            below += bright[i];
            above += bright[i + flank];
        }

        int count = 0;
        for (int i = from + flank; i <= to - flank; i++)
        {
            _edges[i] = (above - below) / flank;
            _histogram[Math.Min(255, (int)(4 * Math.Abs(_edges[i])))]++;
            count++;
            below += bright[i] - bright[i - flank];
            above += i + flank < to ? bright[i + flank] - bright[i] : 0;
        }

        int median = 0;
        for (int sum = _histogram[0]; 2 * sum < count; sum += _histogram[median])
        {
            median++;
        }

        return MedianToSigma * (median + 0.5) / 4;
    }

    private bool IsPeak(int i, int sign)
    {
        double here = sign * _edges[i];
        return here > sign * _edges[i - 1] && here >= sign * _edges[i + 1];
    }

    /// <summary>The place of an edge between cells: the vertex of the parabola through its strength and the two beside it.</summary>
    private double SubCell(int i)
    {
        double before = _edges[i - 1];
        double after = _edges[i + 1];
        double bend = before - (2 * _edges[i]) + after;
        double shift = bend != 0 ? 0.5 * (before - after) / bend : 0;
        return i + Math.Max(-0.5, Math.Min(0.5, shift));
    }

    private static double Mean(float[] values, int from, int to)
    {
        double sum = 0;
        for (int i = from; i < to; i++)
        {
            sum += values[i];
        }

        return to > from ? sum / (to - from) : 0;
    }
}
