namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>A picture with the screen of an object.</summary>
/// <param name="Bytes">Red, green and blue of each pixel, rows from the top.</param>
/// <param name="Nearer">The nearer screens of the picture that may hide that screen.</param>
internal sealed record ScreenPicture(byte[] Bytes, IReadOnlyList<SilhouetteSpans> Nearer)
{
    /// <summary>Whether a nearer screen, widened by a pixel, covers a pixel.</summary>
    public bool IsHidden(int column, int row)
    {
        foreach (SilhouetteSpans spans in Nearer)
        {
            if (
                spans.Contains(column, row)
                || spans.Contains(column - 1, row)
                || spans.Contains(column + 1, row)
                || spans.Contains(column, row - 1)
                || spans.Contains(column, row + 1)
            )
            {
                return true;
            }
        }

        return false;
    }
}
