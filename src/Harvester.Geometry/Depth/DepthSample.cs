namespace Harvester.Geometry.Depth;

/// <summary>What a ray through a pixel met.</summary>
/// <param name="Depth">Depth along the camera's axis, metres; positive infinity if it met nothing.</param>
/// <param name="Surface">The plane of the surface in the camera's frame.</param>
/// <param name="Entity">Handle of the entity that was met.</param>
/// <param name="Region">The number that the mask gives this entity; 0 if the mask does not show it.</param>
public readonly record struct DepthSample(double Depth, SurfacePlane Surface, int Entity, ushort Region)
{
    /// <summary>Whether the ray met anything.</summary>
    public bool IsHit => !double.IsPositiveInfinity(Depth);
}
