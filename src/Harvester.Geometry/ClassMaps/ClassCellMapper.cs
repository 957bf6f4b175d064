namespace Harvester.Geometry.ClassMaps;

/// <summary>Draws one cell from samples, or divides it.</summary>
internal sealed class ClassCellMapper(ClassSamples samples)
{
    /// <summary>Cells of at most this side are not divided further, pixels.</summary>
    private const int MinSide = 3;

    /// <summary>Cells of at most this side need no rays that confirm their outline, pixels.</summary>
    private const int SureSide = 4;

    /// <summary>Distance of the rays that confirm an outline from it, pixels: more than the ½ to which its ends are known.</summary>
    private const double ConfirmDistance = 1.2;

    /// <summary>Samples a cell and draws it.</summary>
    /// <returns>The parts to be mapped next; none if the cell is settled.</returns>
    public IEnumerable<ClassCell> Map(ClassCell cell)
    {
        bool isCovered = false;
        List<(int Column, int Row, byte Class)> corners = [];
        foreach (
            (int column, int row) in new[]
            {
                (cell.Left, cell.Top),
                (cell.Right, cell.Top),
                (cell.Right, cell.Bottom),
                (cell.Left, cell.Bottom),
            }
        )
        {
            isCovered |= samples.IsGiven(column, row);
            if (Nearest(cell, column, row) is { } place)
            {
                corners.Add((place.Column, place.Row, samples.At(place.Column, place.Row)));
            }
        }

        if (corners.Count == 0)
        {
            return [];
        }

        bool isUniform = corners.TrueForAll(corner => corner.Class == corners[0].Class);

        // Where other labels cover part of the cell, an outline may end unseen behind them, so no straight line is assumed.
        Outline? outline = isUniform || isCovered ? null : OutlineIn(corners);
        bool isSettled = Draw(cell, corners, outline);
        if (!isUniform)
        {
            isSettled &= outline is { } line && (cell.Side <= SureSide || IsConfirmed(cell, line));
        }

        return isSettled || cell.Side <= MinSide ? [] : Parts(cell);
    }

    private static IEnumerable<ClassCell> Parts(ClassCell cell)
    {
        int column = (cell.Left + cell.Right) / 2;
        int row = (cell.Top + cell.Bottom) / 2;
        return (
            (ClassCell[])
                [
                    new(cell.Left, cell.Top, column, row),
                    new(column, cell.Top, cell.Right, row),
                    new(cell.Left, row, column, cell.Bottom),
                    new(column, row, cell.Right, cell.Bottom),
                ]
        ).Where(part => part.Side > 0);
    }

    /// <summary>The pixel nearest to a corner of a cell that is not given; null if all are.</summary>
    private (int Column, int Row)? Nearest(ClassCell cell, int column, int row)
    {
        if (!samples.IsGiven(column, row))
        {
            return (column, row);
        }

        (int Column, int Row)? nearest = null;
        int least = int.MaxValue;
        for (int y = cell.Top; y <= cell.Bottom; y++)
        {
            for (int x = cell.Left; x <= cell.Right; x++)
            {
                int distance = ((x - column) * (x - column)) + ((y - row) * (y - row));
                if (distance < least && !samples.IsGiven(x, y))
                {
                    (nearest, least) = ((x, y), distance);
                }
            }
        }

        return nearest;
    }

    /// <summary>The straight outline between two classes; null unless exactly two sides have a change, between the same classes.</summary>
    private Outline? OutlineIn(List<(int Column, int Row, byte Class)> corners)
    {
        byte first = corners[0].Class;
        byte second = corners.Find(corner => corner.Class != first).Class;
        if (corners.Exists(corner => corner.Class != first && corner.Class != second))
        {
            return null;
        }

        List<Vector2D> changes = [];
        for (int i = 0; i < corners.Count; i++)
        {
            (int Column, int Row, byte Class) from = corners[i];
            (int Column, int Row, byte Class) to = corners[(i + 1) % corners.Count];
            if (from.Class != to.Class)
            {
                if (ChangeBetween(from, to) is not { } change)
                {
                    return null;
                }

                changes.Add(change);
            }
        }

        return changes.Count == 2
            ? new Outline(changes[0], changes[1], new Vector2D(corners[0].Column, corners[0].Row), first, second)
            : null;
    }

    private Vector2D? ChangeBetween((int Column, int Row, byte Class) from, (int Column, int Row, byte Class) to)
    {
        int length = Math.Max(Math.Abs(to.Column - from.Column), Math.Abs(to.Row - from.Row));
        int alongX = Math.Sign(to.Column - from.Column);
        int alongY = Math.Sign(to.Row - from.Row);
        int low = 0;
        int high = length;
        while (high - low > 1)
        {
            int middle = (low + high) / 2;
            int column = from.Column + (alongX * middle);
            int row = from.Row + (alongY * middle);

            // Bisection keeps the first class at low and the second at high; a third class, or a covered pixel, ends the search.
            byte found = samples.IsGiven(column, row) ? (byte)0 : samples.At(column, row);
            if (found == from.Class)
            {
                low = middle;
            }
            else if (found == to.Class)
            {
                high = middle;
            }
            else
            {
                return null;
            }
        }

        // The change lies between two neighbouring pixel centres.
        double at = low + 0.5;
        return new Vector2D(from.Column + (alongX * at), from.Row + (alongY * at));
    }

    /// <returns>Whether no sample in the cell contradicts what was drawn.</returns>
    private bool Draw(ClassCell cell, List<(int Column, int Row, byte Class)> corners, Outline? outline)
    {
        bool isRight = true;
        for (int row = cell.Top; row <= cell.Bottom; row++)
        {
            for (int column = cell.Left; column <= cell.Right; column++)
            {
                byte value = outline is { } line ? line.ClassAt(column, row) : NearestOf(corners, column, row);
                isRight &= samples.Draw(column, row, value);
            }
        }

        return isRight;
    }

    private static byte NearestOf(List<(int Column, int Row, byte Class)> corners, int column, int row)
    {
        byte nearest = 0;
        int least = int.MaxValue;
        foreach ((int x, int y, byte found) in corners)
        {
            int distance = ((x - column) * (x - column)) + ((y - row) * (y - row));
            if (distance < least)
            {
                (nearest, least) = (found, distance);
            }
        }

        return nearest;
    }

    private bool IsConfirmed(ClassCell cell, Outline line)
    {
        Vector2D along = line.To - line.From;

        // Vector of length ConfirmDistance at right angles to the outline.
        Vector2D across = new Vector2D(-along.Y, along.X) * (ConfirmDistance / Math.Max(along.Length, double.Epsilon));
        Vector2D middle = (line.From + line.To) * 0.5;
        return IsAsDrawn(middle + across) && IsAsDrawn(middle + (across * -1));

        bool IsAsDrawn(Vector2D place)
        {
            int column = Math.Min(cell.Right, Math.Max(cell.Left, (int)Math.Round(place.X)));
            int row = Math.Min(cell.Bottom, Math.Max(cell.Top, (int)Math.Round(place.Y)));
            return samples.IsGiven(column, row) || samples.At(column, row) == line.ClassAt(column, row);
        }
    }

    /// <summary>A straight outline between two changes; places are columns and rows.</summary>
    private readonly record struct Outline(Vector2D From, Vector2D To, Vector2D Corner, byte AtCorner, byte Beyond)
    {
        public byte ClassAt(int column, int row) => Side(new Vector2D(column, row)) * Side(Corner) >= 0 ? AtCorner : Beyond;

        private double Side(Vector2D place) => (To - From).Cross(place - From);
    }
}
