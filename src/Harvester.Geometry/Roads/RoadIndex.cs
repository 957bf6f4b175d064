namespace Harvester.Geometry.Roads;

/// <summary>
/// Finds the links near a position without examining the others: a grid of square cells, each with the links that may reach a point in it.
/// Immutable, and so safe for any number of threads.
/// </summary>
public sealed class RoadIndex
{
    /// <summary>
    /// Minimum side of a cell, metres, about the reach of a road, and maximum number of cells along a side, to bound memory.
    /// </summary>
    private const double MinCell = 16;
    private const int MaxCellsPerSide = 2048;

    /// <summary>Number of pieces in which a curve's bounding box is computed; the margin covers a cubic's bulge between them.</summary>
    private const int BoxSteps = 8;

    private readonly double _cell;
    private readonly double _west;
    private readonly double _south;
    private readonly int _columns;
    private readonly int _rows;
    private readonly int[] _starts;
    private readonly int[] _links;

    /// <summary>Creates the index of all drivable links.</summary>
    /// <param name="curves">The centre lines.</param>
    /// <param name="reachOf">Maximum distance from a link's centre line at which it is found, metres; greater than 0.</param>
    public RoadIndex(RoadCurves curves, Func<int, double> reachOf)
    {
        Guard.NotNull(reachOf, nameof(reachOf));
        RoadNetwork network = Guard.NotNull(curves, nameof(curves)).Network;
        var boxes = new List<(int Link, Box2D Box)>();
        double west = double.PositiveInfinity,
            south = west,
            east = -west,
            north = -west;
        for (int i = 0; i < network.Links.Count; i++)
        {
            if (RoadContinuations.IsDrivable(network, network.Links[i]))
            {
                Box2D box = BoxOf(curves.Of(i), Guard.Positive(reachOf(i), nameof(reachOf)));
                boxes.Add((i, box));
                west = Math.Min(west, box.XMin);
                south = Math.Min(south, box.YMin);
                east = Math.Max(east, box.XMax);
                north = Math.Max(north, box.YMax);
            }
        }

        if (boxes.Count == 0)
        {
            _cell = MinCell;
            _starts = [0];
            _links = [];
            return;
        }

        _west = west;
        _south = south;
        _cell = Math.Max(MinCell, Math.Max(east - west, north - south) / MaxCellsPerSide);
        _columns = (int)((east - west) / _cell) + 1;
        _rows = (int)((north - south) / _cell) + 1;
        (_starts, _links) = Fill(boxes);
    }

    /// <summary>Every drivable link that reaches a position, and possibly some that are a little farther away.</summary>
    /// <param name="place">Metres, world; the height is ignored.</param>
    public ArraySegment<int> Near(Vector3D place)
    {
        double column = Math.Floor((place.X - _west) / _cell);
        double row = Math.Floor((place.Y - _south) / _cell);
        if (!(column >= 0 && column < _columns && row >= 0 && row < _rows))
        {
            return new ArraySegment<int>(_links, 0, 0);
        }

        int cell = ((int)row * _columns) + (int)column;
        return new ArraySegment<int>(_links, _starts[cell], _starts[cell + 1] - _starts[cell]);
    }

    private static Box2D BoxOf(RoadCurve curve, double reach)
    {
        double west = double.PositiveInfinity,
            south = west,
            east = -west,
            north = -west;
        for (int i = 0; i <= BoxSteps; i++)
        {
            Vector2D point = curve.GroundAt(i / (double)BoxSteps);
            west = Math.Min(west, point.X);
            south = Math.Min(south, point.Y);
            east = Math.Max(east, point.X);
            north = Math.Max(north, point.Y);
        }

        // Between two of the points a cubic bulges by no more than the length of the piece.
        double margin = reach + (curve.Length / BoxSteps);
        return new Box2D(west - margin, south - margin, east + margin, north + margin);
    }

    private (int[] Starts, int[] Links) Fill(List<(int Link, Box2D Box)> boxes)
    {
        int[] starts = new int[(_columns * _rows) + 1];
        foreach ((_, Box2D box) in boxes)
        {
            ForCells(box, cell => starts[cell + 1]++);
        }

        // Counting sort: counts per cell become the index at which each cell's links start.
        for (int i = 1; i < starts.Length; i++)
        {
            starts[i] += starts[i - 1];
        }

        int[] links = new int[starts[starts.Length - 1]];
        int[] filled = new int[_columns * _rows];
        foreach ((int link, Box2D box) in boxes)
        {
            ForCells(box, cell => links[starts[cell] + filled[cell]++] = link);
        }

        return (starts, links);
    }

    private void ForCells(Box2D box, Action<int> visit)
    {
        int lastColumn = (int)((box.XMax - _west) / _cell);
        int lastRow = (int)((box.YMax - _south) / _cell);
        for (int row = (int)((box.YMin - _south) / _cell); row <= lastRow; row++)
        {
            for (int column = (int)((box.XMin - _west) / _cell); column <= lastColumn; column++)
            {
                visit((row * _columns) + column);
            }
        }
    }
}
