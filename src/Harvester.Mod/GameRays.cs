using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;

namespace Harvester.Mod;

/// <summary>Casts rays in the game. They hit collision bounds, which are coarser than the picture.</summary>
internal sealed class GameRays : ISurfaceRays
{
    // Map 1, vehicles 2, bodies of peds 8 (not their capsules, 4), objects 16, foliage 256.
    private const int WhatHides = 1 | 2 | 8 | 16 | 256;

    // Ignore glass 1, ignore what can be seen through 2, ignore what has no collision 4.
    private const int PassThrough = 1 | 2 | 4;

    private const int NoEntity = 0;
    private readonly HashSet<int> _entities = [];

    /// <summary>Number of rays cast so far.</summary>
    public long Casts { get; private set; }

    /// <summary>Adds an entity of the scene, so that the game need not be asked for each hit.</summary>
    public void Know(int entity) => _entities.Add(entity);

    /// <summary>
    /// Casts a ray. The synchronous probe answers in the same frame; its arguments are passed as ints, because enums are slow.
    /// </summary>
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) => Cast(ray, maxDistance, ignoredEntity, out _);

    /// <inheritdoc/>
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity, out Vector3D normal)
    {
        normal = Vector3D.Zero;
        Casts++;
        Vector3D start = ray.Origin;
        Vector3D end = ray.At(maxDistance);
        int test = Natives.Call<int>(
            Hash.START_EXPENSIVE_SYNCHRONOUS_SHAPE_TEST_LOS_PROBE,
            (float)start.X,
            (float)start.Y,
            (float)start.Z,
            (float)end.X,
            (float)end.Y,
            (float)end.Z,
            WhatHides,
            ignoredEntity,
            PassThrough
        );
        using var hit = new NativeOutput();
        using var point = new NativeOutput();
        using var across = new NativeOutput();
        using var material = new NativeOutput();
        using var entity = new NativeOutput();
        const int ready = 2;
        if (Natives.Call<int>(Hash.GET_SHAPE_TEST_RESULT_INCLUDING_MATERIAL, test, hit, point, across, material, entity) != ready)
        {
            throw new InvalidOperationException("The game did not answer a ray.");
        }

        if (!hit.IsTrue)
        {
            return null;
        }

        normal = across.Vector;
        int met = entity.Integer;
        return new RayHit((point.Vector - start).Length, IsEntity(met) ? met : RayHit.World)
        {
            Material = unchecked((uint)material.Integer),
            NormalZ = normal.Z,
        };
    }

    private bool IsEntity(int handle)
    {
        if (handle == NoEntity || _entities.Contains(handle))
        {
            return handle != NoEntity;
        }

        // A ped, a vehicle or a prop; buildings have no type, and thousands of script handles for them would fill the game's pool.
        if (Natives.Call<int>(Hash.GET_ENTITY_TYPE, handle) != NoEntity)
        {
            return true;
        }

        Natives.Call(Hash.RELEASE_SCRIPT_GUID_FROM_ENTITY, handle);
        return false;
    }
}
