namespace Harvester.Geometry.Grids;

/// <summary>
/// The voxels in which some of a triangle lies: in each upright column of voxels that it meets, a range of layers. Coordinates are columns,
/// rows and layers.
/// </summary>
/// <param name="cells">Number of columns and of rows; layers have no limits.</param>
internal sealed class TriangleVoxels(int cells)
{
    /// <summary>A triangle cut by four planes has at most seven corners.</summary>
    private const int MaxCorners = 8;

    private readonly Outline _whole = new();
    private readonly Outline _half = new();
    private readonly Outline _strip = new();
    private readonly Outline _part = new();
    private int _column;
    private int _lastColumn;
    private int _row;
    private int _lastRow;
    private bool _isOneColumn;

    /// <summary>The number of the present column of voxels: row · cells + column.</summary>
    public int Cell { get; private set; }

    /// <summary>The lowest and the highest layer with some of the triangle in the present column of voxels.</summary>
    public (int First, int Last) Layers { get; private set; }

    /// <summary>Begins with a triangle.</summary>
    public void Begin(Vector3D a, Vector3D b, Vector3D c)
    {
        _whole.Count = 0;
        _whole.Add(a);
        _whole.Add(b);
        _whole.Add(c);
        (double min, double max) = _whole.RangeX();
        (double minRow, double maxRow) = _whole.RangeY();
        if (!(max >= 0 && min < cells && maxRow >= 0 && minRow < cells))
        {
            (_column, _lastColumn, _row, _lastRow) = (0, -1, 0, -1);
            return;
        }

        _column = Inside(min) - 1;
        _lastColumn = Inside(max);
        _isOneColumn = Math.Floor(min) == Math.Floor(max);
        (_row, _lastRow) = (0, -1);
    }

    /// <summary>Goes to the next column of voxels.</summary>
    /// <returns>Whether there is one.</returns>
    public bool Next()
    {
        while (true)
        {
            while (_row < _lastRow)
            {
                // What of the strip lies in the next row: a convex outline, whose corners give the range of layers.
                _row++;
                Outline part = _strip;
                if (_strip.IsAcrossRows)
                {
                    _strip.CutY(_row, _half, isUpper: false);
                    _half.CutY(_row + 1, _part, isUpper: true);
                    part = _part;
                }

                if (part.Count > 0)
                {
                    (double low, double high) = part.RangeZ();
                    Cell = (_row * cells) + _column;
                    Layers = (Floor(low), Floor(high));
                    return true;
                }
            }

            if (_column >= _lastColumn)
            {
                return false;
            }

            // What of the triangle lies in the next column.
            _column++;
            if (_isOneColumn)
            {
                _strip.CopyFrom(_whole);
            }
            else
            {
                _whole.CutX(_column, _half, isUpper: false);
                _half.CutX(_column + 1, _strip, isUpper: true);
            }

            (_row, _lastRow) = (0, -1);
            if (_strip.Count > 0)
            {
                (double first, double last) = _strip.RangeY();
                if (last >= 0 && first < cells)
                {
                    (_row, _lastRow) = (Inside(first) - 1, Inside(last));
                    _strip.IsAcrossRows = Math.Floor(first) != Math.Floor(last);
                }
            }
        }
    }

    private int Inside(double place) => (int)Math.Max(0, Math.Min(cells - 1, Math.Floor(place)));

    private static int Floor(double place) => (int)Math.Floor(Math.Max(-1, Math.Min(int.MaxValue / 2, place)));

    /// <summary>A convex outline.</summary>
    private sealed class Outline
    {
        private readonly double[] _x = new double[MaxCorners];
        private readonly double[] _y = new double[MaxCorners];
        private readonly double[] _z = new double[MaxCorners];

        public int Count { get; set; }

        public bool IsAcrossRows { get; set; }

        public void Add(Vector3D corner) => Add(corner.X, corner.Y, corner.Z);

        public void CopyFrom(Outline other)
        {
            Count = 0;
            for (int i = 0; i < other.Count; i++)
            {
                Add(other._x[i], other._y[i], other._z[i]);
            }
        }

        public (double Min, double Max) RangeX() => RangeOf(_x);

        public (double Min, double Max) RangeY() => RangeOf(_y);

        public (double Min, double Max) RangeZ() => RangeOf(_z);

        /// <summary>Keeps what lies on one side of the plane of a column.</summary>
        public void CutX(double at, Outline kept, bool isUpper) => Cut(_x, at, kept, isUpper);

        /// <summary>Keeps what lies on one side of the plane of a row.</summary>
        public void CutY(double at, Outline kept, bool isUpper) => Cut(_y, at, kept, isUpper);

        private void Add(double x, double y, double z)
        {
            (_x[Count], _y[Count], _z[Count]) = (x, y, z);
            Count++;
        }

        /// <summary>Sutherland and Hodgman's algorithm: corners on the side stay, edges that cross the plane get a corner there.</summary>
        private void Cut(double[] along, double at, Outline kept, bool isUpper)
        {
            kept.Count = 0;
            for (int i = 0; i < Count; i++)
            {
                int next = i + 1 == Count ? 0 : i + 1;
                double from = isUpper ? at - along[i] : along[i] - at;
                double to = isUpper ? at - along[next] : along[next] - at;
                if (from >= 0)
                {
                    kept.Add(_x[i], _y[i], _z[i]);
                }

                if ((from > 0 && to < 0) || (from < 0 && to > 0))
                {
                    double part = from / (from - to);
                    kept.Add(_x[i] + (part * (_x[next] - _x[i])), _y[i] + (part * (_y[next] - _y[i])), _z[i] + (part * (_z[next] - _z[i])));
                }
            }
        }

        private (double Min, double Max) RangeOf(double[] values)
        {
            (double min, double max) = (values[0], values[0]);
            for (int i = 1; i < Count; i++)
            {
                min = values[i] < min ? values[i] : min;
                max = values[i] > max ? values[i] : max;
            }

            return (min, max);
        }
    }
}
