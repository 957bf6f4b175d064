using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>Reads one moment of a game's world into plain data.</summary>
internal sealed class SceneReader(IWorld world, HarvestOptions options)
{
    /// <summary>Distance from the centre up to which entities are read, metres.</summary>
    public double RangeMetres { get; } = Math.Max(options.ReadRangeMetres + options.RigReachMetres, options.LidarReachMetres);

    /// <summary>Reads the scene at once, in the tick in hand.</summary>
    public SceneSnapshot Read()
    {
        CameraState camera = world.ReadCamera();
        return SnapshotOf(camera, [.. world.ReadEntities(CentreFor(camera), RangeMetres)]);
    }

    /// <summary>The place around which entities are read: the camera, or the vehicle, which stands while a rig's camera moves.</summary>
    public Vector3D CentreFor(CameraState camera) => options.Rig is null ? camera.Pose.Position : world.ReadEgo().Pose.Position;

    /// <summary>The snapshot of a moment whose camera and entities are read.</summary>
    public SceneSnapshot SnapshotOf(CameraState camera, List<EntityState> entities)
    {
        entities.Sort(static (a, b) => a.Handle.CompareTo(b.Handle));

        // Which entities are in range of a rig's camera is found out for each view.
        ILookup<bool, EntityState> byRange = entities.ToLookup(entity => options.Rig is not null || options.IsInRange(camera, entity));
        return new SceneSnapshot(world.GameFrame, world.TimeSeconds, camera, world.ReadEgo(), [.. byRange[true]], world.ReadEnvironment())
        {
            Distant = [.. byRange[false]],
        };
    }
}
