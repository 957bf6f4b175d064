namespace Harvester.Geometry;

/// <summary>
/// A point or displacement in space, double precision. World frame: metres, right-handed, x east, y north, z up.
/// Model and camera frames: metres, x right, y forward, z up.
/// </summary>
/// <param name="X">First component.</param>
/// <param name="Y">Second component.</param>
/// <param name="Z">Third component.</param>
public readonly record struct Vector3D(double X, double Y, double Z)
{
    /// <summary>The vector (0, 0, 0).</summary>
    public static Vector3D Zero => default;

    /// <summary>Whether all components are finite.</summary>
    public bool IsFinite => IsFiniteNumber(X) && IsFiniteNumber(Y) && IsFiniteNumber(Z);

    /// <summary>Square of the Euclidean length.</summary>
    public double LengthSquared => (X * X) + (Y * Y) + (Z * Z);

    /// <summary>Euclidean length; 0 or more.</summary>
    public double Length => Math.Sqrt(LengthSquared);

    /// <summary>Sum of two vectors.</summary>
    public static Vector3D operator +(Vector3D a, Vector3D b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>Difference of two vectors.</summary>
    public static Vector3D operator -(Vector3D a, Vector3D b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>The opposite vector.</summary>
    public static Vector3D operator -(Vector3D a) => new(-a.X, -a.Y, -a.Z);

    /// <summary>A vector scaled by a factor.</summary>
    public static Vector3D operator *(Vector3D a, double factor) => new(a.X * factor, a.Y * factor, a.Z * factor);

    /// <summary>A vector scaled by a factor.</summary>
    public static Vector3D operator *(double factor, Vector3D a) => a * factor;

    /// <summary>A vector divided by a number.</summary>
    public static Vector3D operator /(Vector3D a, double divisor) => new(a.X / divisor, a.Y / divisor, a.Z / divisor);

    /// <summary>Inner product: x·x' + y·y' + z·z'.</summary>
    public double Dot(Vector3D other) => (X * other.X) + (Y * other.Y) + (Z * other.Z);

    /// <summary>Cross product, right-handed.</summary>
    public Vector3D Cross(Vector3D other) =>
        new((Y * other.Z) - (Z * other.Y), (Z * other.X) - (X * other.Z), (X * other.Y) - (Y * other.X));

    /// <summary>The unit vector of the same direction.</summary>
    /// <exception cref="InvalidOperationException">The vector is zero or not finite, so it has no direction.</exception>
    public Vector3D Normalized()
    {
        double length = Length;
        if (!(length > 0) || double.IsInfinity(length))
        {
            throw new InvalidOperationException("A zero or infinite vector has no direction.");
        }

        return this / length;
    }

    private static bool IsFiniteNumber(double value) => !double.IsNaN(value) && !double.IsInfinity(value);
}
