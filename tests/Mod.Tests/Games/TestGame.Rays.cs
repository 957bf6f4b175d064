using GTA.Native;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Visibility;
using Harvester.Simulation.Rendering;

namespace Harvester.Mod.Tests.Games;

/// <summary>
/// The natives about rays. The world under z = 0 is a building of level concrete, for which each ray makes a script handle.
/// </summary>
internal sealed partial class TestGame
{
    /// <summary>What the game calls the material of the world.</summary>
    public const uint Concrete = 0x46CA81E8;

    private const int Building = 2_000_000;
    private (RayHit? Hit, Ray Ray) _probe;
    private (int Handle, SceneRayCaster? Rays) _shown;
    private int _lastBuildingHandle = Building;

    /// <summary>The ray caster of a scene; null for the entities of this game and its ground.</summary>
    public IRayCaster? SceneRays { get; set; }

    public HashSet<int> LeakedScriptHandles { get; } = [];

    private void AddRayNatives()
    {
        _natives[Hash.START_EXPENSIVE_SYNCHRONOUS_SHAPE_TEST_LOS_PROBE] = a =>
        {
            Vector3D start = ToWorld(a[0], a[1], a[2]);
            Vector3D way = ToWorld(a[3], a[4], a[5]) - start;
            Assert.IsType<int>(a[6]);
            Assert.Equal(7, Assert.IsType<int>(a[8]));
            var ray = new Ray(start, way);
            _probe = (SceneRays is { } scene ? scene.Cast(ray, way.Length, (int)a[7]) : Cast(ray, way.Length, (int)a[7]), ray);
            return 1;
        };
        _natives[Hash.GET_SHAPE_TEST_RESULT_INCLUDING_MATERIAL] = a =>
        {
            Write(a[1], _probe.Hit is not null);
            if (_probe.Hit is { } hit)
            {
                Write(a[2], ToGame(_probe.Ray.At(hit.Distance)));
                Write(a[3], ToGame(new Vector3D(0, 0, hit.NormalZ ?? 0)));
                Write(a[4], unchecked((int)hit.Material));
                Write(a[5], ScriptHandleOf(hit.Entity));
            }

            return 2;
        };
        Do(Hash.RELEASE_SCRIPT_GUID_FROM_ENTITY, a => LeakedScriptHandles.Remove((int)a[0]));
    }

    private RayHit? Cast(Ray ray, double maxDistance, int ignored)
    {
        IEnumerable<RayHit> hits = Entities
            .Where(entity => entity.Key != ignored && entity.Key != Player)
            .Select(entity => (entity.Key, Distance: DistanceTo(entity.Value, entity.Key, ray, maxDistance)))
            .Where(hit => hit.Distance is not null)
            .Select(hit => new RayHit(hit.Distance!.Value, hit.Key));
        double toGround = ray.Direction.Z < 0 ? -ray.Origin.Z / ray.Direction.Z : double.PositiveInfinity;
        var ground = new RayHit(toGround, RayHit.World) { Material = Concrete, NormalZ = 1 };
        RayHit first = hits.Append(ground).MinBy(hit => hit.Distance);
        return first.Distance <= maxDistance ? first : null;
    }

    private double? DistanceTo(GameEntity entity, int handle, Ray ray, double maxDistance)
    {
        if (entity.Shape is not { } shape)
        {
            return Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose).Intersect(ray)?.Entry;
        }

        // Its triangles are sorted once for thousands of rays.
        if (_shown.Handle != handle)
        {
            _shown = (handle, new SceneRayCaster(new RenderScene([new MeshInstance(shape, entity.Pose, handle)])));
        }

        return _shown.Rays!.Cast(ray, maxDistance, RayHit.World)?.Distance;
    }

    private int ScriptHandleOf(int entity)
    {
        if (entity != RayHit.World)
        {
            return entity;
        }

        LeakedScriptHandles.Add(++_lastBuildingHandle);
        return _lastBuildingHandle;
    }
}
