namespace Harvester.Geometry;

/// <summary>
/// A point or displacement in a plane, such as the image (pixels, x right, y down) or the ground (metres, x east, y north).
/// </summary>
/// <param name="X">First component, in the unit of the plane.</param>
/// <param name="Y">Second component, in the unit of the plane.</param>
public readonly record struct Vector2D(double X, double Y)
{
    /// <summary>Euclidean length, in the unit of the components; 0 or more.</summary>
    public double Length => Math.Sqrt((X * X) + (Y * Y));

    /// <summary>Sum of two vectors.</summary>
    public static Vector2D operator +(Vector2D a, Vector2D b) => new(a.X + b.X, a.Y + b.Y);

    /// <summary>Difference of two vectors.</summary>
    public static Vector2D operator -(Vector2D a, Vector2D b) => new(a.X - b.X, a.Y - b.Y);

    /// <summary>A vector scaled by a factor.</summary>
    public static Vector2D operator *(Vector2D a, double factor) => new(a.X * factor, a.Y * factor);

    /// <summary>Inner product: x·x' + y·y'.</summary>
    public double Dot(Vector2D other) => (X * other.X) + (Y * other.Y);

    /// <summary>
    /// The z component of the cross product: positive when <paramref name="other"/> lies counter-clockwise of this in an x-right, y-up
    /// plane.
    /// </summary>
    public double Cross(Vector2D other) => (X * other.Y) - (Y * other.X);
}
