using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>
/// Heights of the ground on a square grid. Cells that are nearly flat are drawn as two triangles, the others in smaller ones.
/// </summary>
internal sealed class TerrainGrid
{
    /// <summary>Side of a cell, metres.</summary>
    public const double CellSize = 10;

    /// <summary>Smaller cells along a side of a cell.</summary>
    public const int Split = 4;

    /// <summary>Side of a smaller cell, metres.</summary>
    public const double FineSize = CellSize / Split;

    /// <summary>Unevenness that is not worth smaller triangles, metres; the ground lies deeper than that below roads.</summary>
    private const double Flat = 0.2;

    private readonly double _west;
    private readonly double _south;
    private readonly double[,] _heights;
    private bool[,] _isFine = new bool[0, 0];

    /// <param name="west">Western border, metres.</param>
    /// <param name="south">Southern border, metres.</param>
    /// <param name="columns">Cells to the east.</param>
    /// <param name="rows">Cells to the north.</param>
    public TerrainGrid(double west, double south, int columns, int rows)
    {
        _west = west;
        _south = south;
        _heights = new double[(columns * Split) + 1, (rows * Split) + 1];
        Columns = columns;
        Rows = rows;
    }

    public int Columns { get; }

    public int Rows { get; }

    /// <summary>Number of points of smaller cells from west to east.</summary>
    public int Width => (Columns * Split) + 1;

    /// <summary>Number of points of smaller cells from south to north.</summary>
    public int Height => (Rows * Split) + 1;

    public ref double this[int i, int j] => ref _heights[i, j];

    public double XOf(int i) => _west + (i * FineSize);

    public double YOf(int j) => _south + (j * FineSize);

    /// <summary>The number of the last point at or west of a place; it may lie outside the grid.</summary>
    public int ColumnAt(double x) => (int)Math.Floor((x - _west) / FineSize);

    public int RowAt(double y) => (int)Math.Floor((y - _south) / FineSize);

    public Vector3D Corner(int i, int j) => new(XOf(i), YOf(j), _heights[i, j]);

    /// <summary>Chooses the size of the triangles, once all heights are set.</summary>
    public void Finish()
    {
        _isFine = new bool[Columns, Rows];
        for (int i = 0; i < Columns; i++)
        {
            for (int j = 0; j < Rows; j++)
            {
                _isFine[i, j] = !IsFlat(i * Split, j * Split);
            }
        }

        // A large triangle has a straight edge, and so have the small ones beside it.
        for (int i = 0; i < Columns; i++)
        {
            for (int j = 0; j < Rows; j++)
            {
                if (!_isFine[i, j])
                {
                    Straighten(i * Split, j * Split);
                }
            }
        }
    }

    /// <summary>Height of the ground as it is drawn, metres; outside the grid that of its border.</summary>
    public double HeightAt(Vector3D place)
    {
        double x = Math.Clamp((place.X - _west) / CellSize, 0, Columns - 0.001);
        double y = Math.Clamp((place.Y - _south) / CellSize, 0, Rows - 0.001);
        int size = _isFine[(int)x, (int)y] ? 1 : Split;
        double scale = (double)Split / size;
        int i = (int)(x * scale);
        int j = (int)(y * scale);
        double u = (x * scale) - i;
        double v = (y * scale) - j;
        (i, j) = (i * size, j * size);

        // Linear interpolation in the triangle of the cell that contains the place; the diagonal u = v divides it.
        double near = _heights[i, j];
        double far = _heights[i + size, j + size];
        double beside = u > v ? _heights[i + size, j] : _heights[i, j + size];
        return u > v ? near + (u * (beside - near)) + (v * (far - beside)) : near + (v * (beside - near)) + (u * (far - beside));
    }

    /// <summary>The triangles, each with the middle of its cell.</summary>
    public IEnumerable<(Vector3D A, Vector3D B, Vector3D C)> Triangles()
    {
        for (int i = 0; i < Columns; i++)
        {
            for (int j = 0; j < Rows; j++)
            {
                int size = _isFine[i, j] ? 1 : Split;
                for (int k = i * Split; k < (i + 1) * Split; k += size)
                {
                    for (int l = j * Split; l < (j + 1) * Split; l += size)
                    {
                        yield return (Corner(k, l), Corner(k + size, l), Corner(k + size, l + size));
                        yield return (Corner(k, l), Corner(k + size, l + size), Corner(k, l + size));
                    }
                }
            }
        }
    }

    /// <summary>The points on the border of the grid, counter-clockwise.</summary>
    public List<Vector3D> Border()
    {
        int last = Width - 1;
        int top = Height - 1;
        return
        [
            .. Enumerable.Range(0, Columns).Select(i => Corner(i * Split, 0)),
            .. Enumerable.Range(0, Rows).Select(j => Corner(last, j * Split)),
            .. Enumerable.Range(0, Columns).Select(i => Corner(last - (i * Split), top)),
            .. Enumerable.Range(0, Rows).Select(j => Corner(0, top - (j * Split))),
        ];
    }

    private bool IsFlat(int i, int j)
    {
        for (int k = 0; k <= Split; k++)
        {
            for (int l = 0; l <= Split; l++)
            {
                if (Math.Abs(_heights[i + k, j + l] - LargeAt(i, j, k, l)) > Flat)
                {
                    return false;
                }
            }
        }

        return true;
    }

    /// <summary>The height of a point if its cell is drawn as two triangles.</summary>
    private double LargeAt(int i, int j, int k, int l)
    {
        double near = _heights[i, j];
        double far = _heights[i + Split, j + Split];
        double beside = k > l ? _heights[i + Split, j] : _heights[i, j + Split];
        return near + ((Math.Max(k, l) * (beside - near)) + (Math.Min(k, l) * (far - beside))) / Split;
    }

    private void Straighten(int i, int j)
    {
        for (int k = 0; k <= Split; k++)
        {
            for (int l = 0; l <= Split; l++)
            {
                _heights[i + k, j + l] = LargeAt(i, j, k, l);
            }
        }
    }
}
