using Harvester.Geometry.Cameras;
using Harvester.Runs.Faults;

namespace Harvester.Runs.Sheets;

/// <summary>Where the tiles of a contact sheet lie: row by row, each picture with its caption below.</summary>
public sealed record SheetLayout
{
    private const int Gap = 4;

    /// <summary>Widest and highest sheet, pixels: what all viewers of pictures open.</summary>
    private const int MaxSide = 16384;

    /// <summary>Most pixels of a sheet. With its compressed form and the worlds of its tiles, it takes up to 0.9 GB.</summary>
    private const long MaxPixels = 50_000_000;

    private readonly int _rowHeight;

    private SheetLayout(ImageSize tile, int columns, int rowHeight, ImageSize sheet) =>
        (Tile, Columns, _rowHeight, Sheet) = (tile, columns, rowHeight, sheet);

    /// <summary>Size of a picture, pixels.</summary>
    public ImageSize Tile { get; }

    /// <summary>Tiles of a row.</summary>
    public int Columns { get; }

    /// <summary>Size of the sheet, pixels.</summary>
    public ImageSize Sheet { get; }

    /// <summary>
    /// With several weathers and several times, a row per place and weather and a column per time. Otherwise a row per place if places have
    /// several tiles, and about as many rows as columns if they have one.
    /// </summary>
    /// <exception cref="UsageException">The sheet would be too large.</exception>
    public static SheetLayout Of(SheetPlan plan)
    {
        long times = (long)plan.Times.Count * plan.Seconds.Count;
        long moments = plan.Weathers.Count * times;
        long columns =
            plan.Weathers.Count > 1 && times > 1 ? times
            : moments > 1 ? moments
            : (int)Math.Ceiling(Math.Sqrt(plan.Places.Count));
        long rows = ((plan.Places.Count * moments) + columns - 1) / columns;
        int lines = plan.Captions.Max(caption => CaptionFont.LinesOf(caption, plan.Tile.Width).Count);
        int rowHeight = plan.Tile.Height + CaptionFont.HeightOf(lines);
        long width = (columns * (plan.Tile.Width + Gap)) + Gap;
        long height = (rows * rowHeight) + Gap;
        string limit =
            Math.Max(width, height) > MaxSide ? $"{MaxSide} a side"
            : width * height > MaxPixels ? $"{MaxPixels} in all"
            : "";
        return limit.Length == 0
            ? new SheetLayout(plan.Tile, (int)columns, rowHeight, new ImageSize((int)width, (int)height))
            : throw new UsageException(
                $"The sheet would have {width} x {height} pixels, more than {limit}; give fewer tiles or a smaller --size."
            );
    }

    /// <summary>Upper left corner of a tile's picture, pixels.</summary>
    public (int Left, int Top) CornerOf(int tile) => (Gap + (tile % Columns * (Tile.Width + Gap)), Gap + (tile / Columns * _rowHeight));
}
