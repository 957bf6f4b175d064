using System.Collections.Generic;
using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;
using Harvester.Geometry;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.Ports;

/// <summary>What is read of the simulated world.</summary>
internal sealed class WorldPort(SimulatedGame game) : IWorld
{
    public long GameFrame => game.GameFrame;

    public double TimeSeconds => game.World.TimeSeconds;

    public CameraState ReadCamera() => game.Camera;

    public EgoState ReadEgo()
    {
        Vehicle ego = game.World.Ego;
        return new EgoState(ego.Handle, ego.Model.Name, ego.Pose, ego.Velocity) { ModelMin = ego.Model.Min, ModelMax = ego.Model.Max };
    }

    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range) => game.World.EntitiesNear(centre, range);

    public EnvironmentState ReadEnvironment() => game.Environment;
}
