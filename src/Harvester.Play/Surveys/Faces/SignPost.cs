namespace Harvester.Play.Surveys.Faces;

/// <summary>
/// The post of a sign: where the model is narrowest over at least a hand's length. The tips of triangles and diamonds are narrower than a
/// post, but not over such a length.
/// </summary>
internal sealed class SignPost
{
    /// <summary>Minimum visible length of a post, metres.</summary>
    private const double SeenLength = 0.3;

    /// <summary>A row belongs to a face if it is wider than the post by this factor and by a minimum in metres.</summary>
    private const double WiderByFactor = 1.5;
    private const double WiderByMetres = 0.06;

    private readonly bool[] _columns;
    private readonly double _widest;

    private SignPost(bool[] columns, int row, double widest, bool isWhole)
    {
        _columns = columns;
        Row = row;
        _widest = widest;
        IsWhole = isWhole;
    }

    /// <summary>A row that shows only the post.</summary>
    public int Row { get; }

    /// <summary>Whether the model is about equally narrow everywhere, so that there is no post.</summary>
    public bool IsWhole { get; }

    /// <summary>The columns of the post.</summary>
    public IEnumerable<int> Columns => Enumerable.Range(0, _columns.Length).Where(HasColumn);

    /// <summary>Finds the post; null if no ray hit the model.</summary>
    public static SignPost? Find(ModelDepths grid)
    {
        int[] rows = [.. Enumerable.Range(0, grid.Rows).Where(row => grid.Width(row) > 0)];
        if (rows.Length == 0)
        {
            return null;
        }

        int[] widths = [.. rows.Select(grid.Width)];
        int length = Math.Min(widths.Length, (int)Math.Ceiling(SeenLength / grid.Step));
        (int First, int Width) narrowest = Enumerable
            .Range(0, widths.Length - length + 1)
            .Select(first => (first, widths.Skip(first).Take(length).OrderBy(width => width).ElementAt(length / 2)))
            .OrderBy(window => window.Item2)
            .First();
        bool isWhole = narrowest.Width * WiderByFactor > widths.Max();
        bool[] columns = new bool[grid.Columns];
        int middle = rows[narrowest.First];
        foreach (int row in rows.Skip(narrowest.First).Take(length).Where(row => !isWhole && grid.Width(row) == narrowest.Width))
        {
            middle = row;
            for (int column = 0; column < grid.Columns; column++)
            {
                columns[column] |= grid[column, row] is not null;
            }
        }

        double widest = isWhole ? 0 : Math.Max(narrowest.Width * WiderByFactor, narrowest.Width + (WiderByMetres / grid.Step));
        return new SignPost(columns, middle, widest, isWhole);
    }

    /// <summary>Whether a row of this many cells is wider than a post.</summary>
    public bool IsNarrowerThan(int width) => width > _widest;

    /// <summary>Whether the post covers a column.</summary>
    public bool HasColumn(int column) => column >= 0 && column < _columns.Length && _columns[column];

    /// <summary>Whether the post or its edge may be in a column.</summary>
    public bool IsNear(int column) => HasColumn(column - 1) || HasColumn(column) || HasColumn(column + 1);
}
