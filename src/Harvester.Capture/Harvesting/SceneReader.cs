using System.Collections.Generic;
using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>Reads one moment of a game's world as plain data.</summary>
internal sealed class SceneReader(IWorld world, double rangeMetres)
{
    public SceneSnapshot Read()
    {
        CameraState camera = world.ReadCamera();
        var entities = new List<EntityState>(world.ReadEntities(camera.Pose.Position, rangeMetres));
        entities.Sort(static (a, b) => a.Handle.CompareTo(b.Handle));
        return new SceneSnapshot(
            world.GameFrame, world.TimeSeconds, camera, world.ReadEgo(), entities, world.ReadEnvironment());
    }
}
