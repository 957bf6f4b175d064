namespace Harvester.Geometry.Visibility;

/// <summary>The first thing that a ray hit.</summary>
/// <param name="Distance">Distance from the ray's origin, metres; 0 or more.</param>
/// <param name="Entity">Handle of the entity that was hit; <see cref="World"/> for ground, buildings and everything else that is not an
/// entity.</param>
public readonly record struct RayHit(double Distance, int Entity)
{
    /// <summary>Hash of the material of the surface, as the game names it; 0 if it is not reported.</summary>
    public uint Material { get; init; }

    /// <summary>Vertical part of the surface's unit normal: 1 for level ground, 0 for a wall. Null if it is not reported.</summary>
    public double? NormalZ { get; init; }

    /// <summary>The handle of everything that is not an entity.</summary>
    public const int World = 0;
}
