namespace Harvester.Geometry;

/// <summary>A rectangle of the image with sides along its axes, in continuous pixels: pixel (i, j) covers [i, i+1) × [j, j+1).</summary>
/// <param name="XMin">Left side.</param>
/// <param name="YMin">Upper side.</param>
/// <param name="XMax">Right side, at least <paramref name="XMin"/>.</param>
/// <param name="YMax">Lower side, at least <paramref name="YMin"/>.</param>
public readonly record struct Box2D(double XMin, double YMin, double XMax, double YMax)
{
    /// <summary>Width in pixels; 0 or more.</summary>
    public double Width => XMax - XMin;

    /// <summary>Height in pixels; 0 or more.</summary>
    public double Height => YMax - YMin;

    /// <summary>Area in square pixels.</summary>
    public double Area => Width * Height;

    /// <summary>The part that two boxes share, or null if they share no area.</summary>
    public Box2D? Intersect(Box2D other)
    {
        var shared = new Box2D(
            Math.Max(XMin, other.XMin),
            Math.Max(YMin, other.YMin),
            Math.Min(XMax, other.XMax),
            Math.Min(YMax, other.YMax)
        );
        return shared.Width > 0 && shared.Height > 0 ? shared : null;
    }

    /// <summary>The smallest box around two boxes.</summary>
    public Box2D Union(Box2D other) =>
        new(Math.Min(XMin, other.XMin), Math.Min(YMin, other.YMin), Math.Max(XMax, other.XMax), Math.Max(YMax, other.YMax));

    /// <summary>Intersection over union of two boxes, 0 to 1; 0 if they share no area.</summary>
    public double IntersectionOverUnion(Box2D other) =>
        Intersect(other) is { } shared ? shared.Area / (Area + other.Area - shared.Area) : 0;

    /// <summary>Whether another box lies within this one, sides included, with a margin in pixels.</summary>
    public bool Contains(Box2D other, double margin = 0) =>
        other.XMin >= XMin - margin && other.YMin >= YMin - margin && other.XMax <= XMax + margin && other.YMax <= YMax + margin;

    /// <summary>Whether a point lies within this box: left and upper sides included, right and lower sides not.</summary>
    public bool Contains(Vector2D point) => point.X >= XMin && point.X < XMax && point.Y >= YMin && point.Y < YMax;
}
