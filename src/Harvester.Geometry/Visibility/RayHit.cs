namespace Harvester.Geometry.Visibility;

/// <summary>The first thing that a ray hit.</summary>
/// <param name="Distance">Distance from the ray's origin, metres; 0 or more.</param>
/// <param name="Entity">Handle of the entity that was hit; <see cref="World"/> for ground, buildings and everything else that is not an
/// entity.</param>
public readonly record struct RayHit(double Distance, int Entity)
{
    /// <summary>The handle of everything that is not an entity.</summary>
    public const int World = 0;
}
