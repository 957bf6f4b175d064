namespace Harvester.Geometry.Depth;

/// <summary>A line along which a depth is measured, in the frame of the eye.</summary>
/// <param name="Direction">Its direction; depths are multiples of its length.</param>
/// <param name="Origin">Where it begins, metres; zero for an eye that does not move.</param>
public readonly record struct SightLine(Vector3D Direction, Vector3D Origin = default)
{
    /// <summary>The point at a depth.</summary>
    public Vector3D At(double depth) => Origin + (Direction * depth);
}
