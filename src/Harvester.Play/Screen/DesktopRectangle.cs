namespace Harvester.Play.Screen;

/// <summary>
/// A rectangle of the desktop in physical pixels; the origin is the primary monitor's upper left corner, so left and top may be negative.
/// </summary>
/// <param name="Left">First column.</param>
/// <param name="Top">First row.</param>
/// <param name="Right">The column after the last.</param>
/// <param name="Bottom">The row after the last.</param>
internal readonly record struct DesktopRectangle(int Left, int Top, int Right, int Bottom)
{
    public int Width => Right - Left;

    public int Height => Bottom - Top;

    public bool IsEmpty => Right <= Left || Bottom <= Top;

    public long Area => IsEmpty ? 0 : (long)Width * Height;

    /// <summary>The intersection of two rectangles; empty if they do not overlap.</summary>
    public DesktopRectangle Intersect(DesktopRectangle other) =>
        new(Math.Max(Left, other.Left), Math.Max(Top, other.Top), Math.Min(Right, other.Right), Math.Min(Bottom, other.Bottom));

    public bool Overlaps(DesktopRectangle other) => !Intersect(other).IsEmpty;
}
