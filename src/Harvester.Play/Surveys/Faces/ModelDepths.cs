using Harvester.Geometry.Work;

namespace Harvester.Play.Surveys.Faces;

/// <summary>
/// Depths of a model over a grid of rays along its y axis, seen from behind (from -y). Cells are squares; row 0 is the lowest. Between two
/// rays that hit the same surface, or both hit nothing, no further rays are cast.
/// </summary>
internal sealed class ModelDepths
{
    /// <summary>Number of cells between two rays that are always cast.</summary>
    private const int Stride = 4;

    /// <summary>
    /// One row in this many is cast completely, so that a post thinner than the stride is hit. The following rows are searched where it
    /// was.
    /// </summary>
    private const int WholeEvery = 8 * Stride;

    /// <summary>Maximum difference in depth of two rays on the same surface, metres.</summary>
    private const double SameSurface = 0.002;

    private readonly double _left;
    private readonly double _bottom;
    private readonly double?[,] _depths;

    /// <summary>Creates an empty grid over a rectangle.</summary>
    public ModelDepths(double left, double bottom, double right, double top, double step)
    {
        _left = left;
        _bottom = bottom;
        Step = step;
        Columns = Math.Max(1, (int)Math.Ceiling((right - left) / step));
        Rows = Math.Max(1, (int)Math.Ceiling((top - bottom) / step));
        _depths = new double?[Columns, Rows];
    }

    public double Step { get; }

    public int Columns { get; }

    public int Rows { get; }

    public double? this[int column, int row] => _depths[column, row];

    public double XOf(double column) => _left + (column * Step);

    public double ZOf(double row) => _bottom + (row * Step);

    /// <summary>The column at a position, which may lie outside the grid.</summary>
    public int ColumnOf(double x) => (int)Math.Floor((x - _left) / Step);

    /// <summary>Casts the rays, one per element.</summary>
    public IEnumerable<WorkStep> Fill(StageProbe probe)
    {
        int below = 0;
        for (int row = 0; row < Rows; row = row == Rows - 1 ? Rows : Math.Min(row + Stride, Rows - 1))
        {
            yield return WorkStep.Do(FillRow(probe, row, below));

            bool isSame = Enumerable.Range(0, Columns).All(column => IsSame(_depths[column, below], _depths[column, row]));
            for (int between = below + 1; between < row; between++)
            {
                if (isSame)
                {
                    Copy(below, between);
                    continue;
                }

                yield return WorkStep.Do(FillRow(probe, between, below));
            }

            below = row;
        }
    }

    /// <summary>Number of cells of a row in which the model was hit.</summary>
    public int Width(int row)
    {
        int width = 0;
        for (int column = 0; column < Columns; column++)
        {
            width += _depths[column, row] is null ? 0 : 1;
        }

        return width;
    }

    /// <summary>The median of a row's depths in some of its columns; null if there is none.</summary>
    public double? MedianDepth(int row, Func<int, bool> isCounted)
    {
        var depths = new List<double>();
        for (int column = 0; column < Columns; column++)
        {
            if (isCounted(column) && _depths[column, row] is { } depth)
            {
                depths.Add(depth);
            }
        }

        depths.Sort();
        return depths.Count == 0 ? null : depths[depths.Count / 2];
    }

    private static bool IsSame(double? one, double? other) =>
        one is { } first && other is { } second ? Math.Abs(first - second) <= SameSurface : one is null && other is null;

    /// <summary>Casts a row: at each stride and where another row changes, and then between neighbours that differ.</summary>
    private IEnumerable<WorkStep> FillRow(StageProbe probe, int row, int other)
    {
        bool isWhole = row % WholeEvery == 0;
        int last = -1;
        for (int column = 0; column < Columns; column++)
        {
            if (!isWhole && column % Stride != 0 && column != Columns - 1 && !Changes(other, column))
            {
                continue;
            }

            _depths[column, row] = probe.FromBehind(XOf(column + 0.5), ZOf(row + 0.5));
            yield return WorkStep.Pause;
            bool isSame = last >= 0 && IsSame(_depths[last, row], _depths[column, row]);
            for (int between = last + 1; between < column; between++)
            {
                _depths[between, row] = isSame ? _depths[last, row] : probe.FromBehind(XOf(between + 0.5), ZOf(row + 0.5));
                if (!isSame)
                {
                    yield return WorkStep.Pause;
                }
            }

            last = column;
        }
    }

    /// <summary>Whether a cell of a row differs from one beside it.</summary>
    private bool Changes(int row, int column) =>
        (column > 0 && !IsSame(_depths[column - 1, row], _depths[column, row]))
        || (column < Columns - 1 && !IsSame(_depths[column, row], _depths[column + 1, row]));

    private void Copy(int from, int to)
    {
        for (int column = 0; column < Columns; column++)
        {
            _depths[column, to] = _depths[column, from];
        }
    }
}
