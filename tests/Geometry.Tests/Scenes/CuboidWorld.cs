using Harvester.Geometry.Boxes;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.Tests.Scenes;

/// <summary>A world of cuboids, several of which may belong to one entity, and a ray caster for it.</summary>
internal sealed class CuboidWorld(IReadOnlyList<(int Entity, Cuboid Solid)> solids) : IRayCaster
{
    public int RaysCast { get; private set; }

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        RaysCast++;
        RayHit? nearest = null;
        foreach ((int entity, Cuboid solid) in solids)
        {
            // A ray that starts in a solid does not hit it, as in the game.
            if (
                (entity != ignoredEntity || entity == RayHit.World)
                && solid.Intersect(ray) is { Entry: > 0 } span
                && span.Entry <= maxDistance
                && (nearest is not { } known || span.Entry < known.Distance)
            )
            {
                nearest = new RayHit(span.Entry, entity);
            }
        }

        return nearest;
    }
}
