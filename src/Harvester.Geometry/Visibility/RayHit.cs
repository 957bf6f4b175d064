namespace Harvester.Geometry.Visibility;

/// <summary>What a ray met first.</summary>
/// <param name="Distance">Distance from the ray's origin, metres; 0 or more.</param>
/// <param name="Entity">Handle of the entity that was hit; <see cref="World"/> for ground, buildings and whatever is no entity.</param>
public readonly record struct RayHit(double Distance, int Entity)
{
    /// <summary>The handle that stands for what is no entity.</summary>
    public const int World = 0;
}
