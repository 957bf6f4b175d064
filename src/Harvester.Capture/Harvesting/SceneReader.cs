using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Ports;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>Reads one moment of a game's world into plain data.</summary>
internal sealed class SceneReader(IWorld world, HarvestOptions options)
{
    public SceneSnapshot Read()
    {
        CameraState camera = world.ReadCamera();
        var entities = new List<EntityState>(world.ReadEntities(camera.Pose.Position, options.ReadRangeMetres));
        entities.Sort(static (a, b) => a.Handle.CompareTo(b.Handle));
        ILookup<bool, EntityState> byRange = entities.ToLookup(entity => options.IsInRange(camera, entity));
        return new SceneSnapshot(world.GameFrame, world.TimeSeconds, camera, world.ReadEgo(), [.. byRange[true]], world.ReadEnvironment())
        {
            Distant = [.. byRange[false]],
        };
    }
}
