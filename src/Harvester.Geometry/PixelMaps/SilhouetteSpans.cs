using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// A convex silhouette as the pixels whose centres it covers: for each row the first and last column, for each column the first and last
/// row. The last of an empty span is less than its first.
/// </summary>
internal sealed class SilhouetteSpans
{
    private readonly (int First, int Last)[] _rows;
    private readonly (int First, int Last)[] _columns;

    public SilhouetteSpans(IReadOnlyList<Vector2D> silhouette, Box2D box, ImageSize image)
    {
        FirstColumn = Math.Max(0, (int)Math.Floor(box.XMin));
        FirstRow = Math.Max(0, (int)Math.Floor(box.YMin));
        LastColumn = Math.Min(image.Width, (int)Math.Ceiling(box.XMax)) - 1;
        LastRow = Math.Min(image.Height, (int)Math.Ceiling(box.YMax)) - 1;
        _rows = new (int, int)[Math.Max(0, LastRow - FirstRow + 1)];
        for (int i = 0; i < _rows.Length; i++)
        {
            _rows[i] = Span(silhouette, FirstRow + i + 0.5, p => p.Y, p => p.X, FirstColumn, LastColumn);
            PixelCount += Math.Max(0, _rows[i].Last - _rows[i].First + 1);
        }

        _columns = new (int, int)[Math.Max(0, LastColumn - FirstColumn + 1)];
        for (int i = 0; i < _columns.Length; i++)
        {
            _columns[i] = Span(silhouette, FirstColumn + i + 0.5, p => p.X, p => p.Y, FirstRow, LastRow);
        }
    }

    public int FirstColumn { get; }

    public int LastColumn { get; }

    public int FirstRow { get; }

    public int LastRow { get; }

    /// <summary>Number of pixels in the image whose centres the silhouette covers.</summary>
    public int PixelCount { get; }

    public bool BoxMeets(MapCell cell) =>
        FirstColumn <= cell.Right && LastColumn >= cell.Left && FirstRow <= cell.Bottom && LastRow >= cell.Top;

    /// <summary>Number of pixels that the silhouette shares with a cell.</summary>
    public int PixelsIn(MapCell cell)
    {
        int pixels = 0;
        for (int row = cell.Top; row <= cell.Bottom; row++)
        {
            (int first, int last) = Row(row);
            pixels += Math.Max(0, Math.Min(last, cell.Right) - Math.Max(first, cell.Left) + 1);
        }

        return pixels;
    }

    public (int First, int Last) Row(int row) => row >= FirstRow && row <= LastRow ? _rows[row - FirstRow] : (0, -1);

    public (int First, int Last) Column(int column) =>
        column >= FirstColumn && column <= LastColumn ? _columns[column - FirstColumn] : (0, -1);

    public bool Contains(int column, int row)
    {
        (int first, int last) = Row(row);
        return column >= first && column <= last;
    }

    private static (int First, int Last) Span(
        IReadOnlyList<Vector2D> silhouette,
        double at,
        Func<Vector2D, double> across,
        Func<Vector2D, double> along,
        int first,
        int last
    )
    {
        double low = double.PositiveInfinity;
        double high = double.NegativeInfinity;
        for (int i = 0; i < silhouette.Count; i++)
        {
            Vector2D a = silhouette[i];
            Vector2D b = silhouette[(i + 1) % silhouette.Count];
            double da = across(a) - at;
            double db = across(b) - at;

            // The line of pixel centres crosses the sides of a convex outline twice. A corner on the line counts to one side only.
            if ((da <= 0) == (db <= 0))
            {
                continue;
            }

            double crossing = along(a) + ((along(b) - along(a)) * (da / (da - db)));
            low = Math.Min(low, crossing);
            high = Math.Max(high, crossing);
        }

        // Pixel i is covered if low ≤ i + ½ < high, so outlines that share a side share no pixel.
        return high < low ? (0, -1) : ((int)Math.Max(first, Math.Ceiling(low - 0.5)), (int)Math.Min(last, Math.Ceiling(high - 0.5) - 1));
    }
}
