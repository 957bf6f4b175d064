namespace Harvester.Geometry;

/// <summary>A half-line in the world. A point at distance t, in metres, is Origin + t · Direction.</summary>
public readonly record struct Ray
{
    /// <summary>Creates a ray; the direction is scaled to unit length.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The origin is not finite.</exception>
    /// <exception cref="InvalidOperationException">The direction is zero or not finite.</exception>
    public Ray(Vector3D origin, Vector3D direction)
    {
        Origin = Guard.Finite(origin, nameof(origin));
        Direction = direction.Normalized();
    }

    /// <summary>Start, metres, world.</summary>
    public Vector3D Origin { get; }

    /// <summary>Unit vector, world.</summary>
    public Vector3D Direction { get; }

    /// <summary>The point at a distance from the origin, metres.</summary>
    public Vector3D At(double distance) => Origin + (Direction * distance);
}
