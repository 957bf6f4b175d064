using System.Collections.Generic;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Visibility;

namespace Harvester.Cli.Boxes;

/// <summary>Casts rays at solid cuboids; the cuboid at index i is the entity i + 1.</summary>
internal sealed class CuboidRayCaster : IRayCaster
{
    private readonly IReadOnlyList<Cuboid> _cuboids;

    public CuboidRayCaster(IReadOnlyList<Cuboid> cuboids) => _cuboids = cuboids;

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        RayHit? nearest = null;
        for (int i = 0; i < _cuboids.Count; i++)
        {
            int entity = i + 1;
            if (entity != ignoredEntity && _cuboids[i].Intersect(ray) is { } span
                && span.Entry <= maxDistance && !(nearest?.Distance <= span.Entry))
            {
                nearest = new RayHit(span.Entry, entity);
            }
        }

        return nearest;
    }
}
