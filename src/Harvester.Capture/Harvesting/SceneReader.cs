using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Work;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>Reads one moment of a game's world into plain data.</summary>
internal sealed class SceneReader(IWorld world, HarvestOptions options)
{
    private readonly double _range = Math.Max(options.ReadRangeMetres + options.RigReachMetres, options.LidarReachMetres);

    /// <summary>Reads the scene at once, in the tick in hand.</summary>
    public SceneSnapshot Read()
    {
        CameraState camera = world.ReadCamera();
        return SnapshotOf(camera, [.. world.ReadEntities(CentreFor(camera), _range)]);
    }

    /// <summary>Reads the scene of a frozen game in steps; where the world cannot be read in steps, at once.</summary>
    /// <param name="snapshot">Receives the snapshot, with the frame count of the moment in which the work ends.</param>
    public IEnumerable<WorkStep> ReadInSteps(WorkResult<SceneSnapshot> snapshot)
    {
        if (world is not IStepwiseWorld stepwise)
        {
            snapshot.Value = Read();
            yield break;
        }

        CameraState camera = world.ReadCamera();
        var entities = new List<EntityState>();
        yield return WorkStep.Do(stepwise.ReadEntitiesInSteps(CentreFor(camera), _range, entities));
        snapshot.Value = SnapshotOf(camera, entities);
    }

    /// <summary>The place around which entities are read: the camera, or the vehicle, which stands while a rig's camera moves.</summary>
    private Vector3D CentreFor(CameraState camera) => options.Rig is null ? camera.Pose.Position : world.ReadEgo().Pose.Position;

    private SceneSnapshot SnapshotOf(CameraState camera, List<EntityState> entities)
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
