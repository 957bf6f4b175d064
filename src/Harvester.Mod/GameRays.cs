using System.Collections.Generic;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;

namespace Harvester.Mod;

/// <summary>The game's rays. They see collision bounds, which are coarser than the picture.</summary>
internal sealed class GameRays : IRayCaster
{
    // Map 1, vehicles 2, bodies of peds 8 (not their capsules, 4), objects 16, foliage 256.
    private const int WhatHides = 1 | 2 | 8 | 16 | 256;

    // Through glass 1, what can be seen through 2, and what has no collision 4.
    private const int PassThrough = 1 | 2 | 4;

    private const int NoEntity = 0;
    private readonly HashSet<int> _entities = [];

    /// <summary>Tells which handles are entities of the scene, so that the game need not be asked for each hit.</summary>
    public void Know(int entity) => _entities.Add(entity);

    /// <inheritdoc/>
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        if (Natives.Probe(ray.Origin, ray.At(maxDistance), WhatHides, ignoredEntity, PassThrough) is not { } hit)
        {
            return null;
        }

        return new RayHit((hit.Point - ray.Origin).Length, IsEntity(hit.Entity) ? hit.Entity : RayHit.World);
    }

    private bool IsEntity(int handle)
    {
        if (handle == NoEntity || _entities.Contains(handle))
        {
            return handle != NoEntity;
        }

        if (Natives.EntityType(handle) != NoEntity)
        {
            return true;
        }

        Natives.ReleaseScriptHandle(handle);
        return false;
    }
}
