namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// A model of the inside of a cell from its border, for silhouettes that are straight within it: one number lies in front, and all others
/// on the border are cut off from it by chords.
/// </summary>
internal sealed class CellModel
{
    private readonly int _front;
    private readonly CellCap[] _caps;

    private CellModel(int front, CellCap[] caps)
    {
        _front = front;
        _caps = caps;
    }

    /// <summary>The model with a given number in front, or null if more than two silhouettes meet in a cap.</summary>
    public static CellModel? Build(CellBorder border, int front, Func<int, Vector2D> crossingAfter)
    {
        List<BorderRun> runs = border.Runs;
        var caps = new List<CellCap>();
        int first = 0;
        while (runs[first].Number != front)
        {
            first++;
        }

        for (int i = first; i < first + runs.Count; )
        {
            int begin = i + 1;
            int end = begin;
            while (end < first + runs.Count && runs[end % runs.Count].Number != front)
            {
                end++;
            }

            // A cap is what one chord cuts off between two runs of the front's number. Two numbers in it are divided by a line from the
            // change between them to the middle of the chord; three would need more lines than the border shows.
            int inCap = end - begin;
            if (inCap > 2)
            {
                return null;
            }

            if (inCap > 0)
            {
                BorderRun one = runs[begin % runs.Count];
                BorderRun other = runs[(end - 1) % runs.Count];
                caps.Add(
                    new CellCap(
                        crossingAfter(runs[i % runs.Count].End),
                        crossingAfter(other.End),
                        one.Number,
                        other.Number,
                        inCap == 2 ? crossingAfter(one.End) : default
                    )
                );
            }

            i = end;
        }

        return new CellModel(front, caps.ToArray());
    }

    public int NumberAt(int column, int row)
    {
        var pixel = new Vector2D(column, row);
        for (int i = 0; i < _caps.Length; i++)
        {
            ref readonly CellCap cap = ref _caps[i];
            if (cap.Contains(pixel))
            {
                return cap.NumberAt(pixel);
            }
        }

        return _front;
    }

    /// <summary>Whether all chords run along rows or columns, to within a fraction of a pixel.</summary>
    public bool IsAligned(double pixels) =>
        Array.TrueForAll(_caps, cap => Math.Abs(cap.Start.X - cap.End.X) < pixels || Math.Abs(cap.Start.Y - cap.End.Y) < pixels);

    /// <summary>The pixels that best test the model: on both sides of the middle of every line it draws.</summary>
    public IEnumerable<(int Column, int Row)> Tests()
    {
        foreach (CellCap cap in _caps)
        {
            foreach ((int, int) pixel in BothSides(cap.Start, cap.End))
            {
                yield return pixel;
            }

            if (cap.HasTwoNumbers)
            {
                foreach ((int, int) pixel in BothSides(cap.Change, cap.ChordMiddle))
                {
                    yield return pixel;
                }
            }
        }
    }

    private static IEnumerable<(int Column, int Row)> BothSides(Vector2D from, Vector2D to)
    {
        Vector2D line = to - from;
        double length = line.Length;
        if (length == 0)
        {
            yield break;
        }

        Vector2D middle = (from + to) * 0.5;

        // One pixel off the line on either side: the nearest pixels that must differ if the line is right.
        var normal = new Vector2D(-line.Y / length, line.X / length);
        foreach (double side in new[] { -1.0, 1.0 })
        {
            Vector2D test = middle + (normal * side);
            yield return ((int)Math.Round(test.X), (int)Math.Round(test.Y));
        }
    }
}
