using Harvester.Sessions.Imaging;

namespace Harvester.Runs.Sheets;

/// <summary>The picture of a contact sheet, filled tile by tile.</summary>
public sealed class ContactSheet(SheetLayout layout)
{
    private int _tiles;

    /// <summary>The picture.</summary>
    public PixelBuffer Picture { get; } = new(layout.Sheet);

    /// <summary>Adds the next tile.</summary>
    public void Add(SheetTile tile)
    {
        (int left, int top) = layout.CornerOf(_tiles++);
        int rowBytes = layout.Tile.Width * PixelBuffer.BytesPerPixel;
        for (int row = 0; row < layout.Tile.Height; row++)
        {
            Buffer.BlockCopy(
                tile.Picture.Bytes,
                row * rowBytes,
                Picture.Bytes,
                (((top + row) * layout.Sheet.Width) + left) * PixelBuffer.BytesPerPixel,
                rowBytes
            );
        }

        CaptionFont.Write(Picture, tile.Caption, left, top + layout.Tile.Height, layout.Tile.Width);
    }
}
