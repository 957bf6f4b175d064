using System.Collections.Generic;
using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;
using Harvester.Geometry;

namespace Harvester.Simulation.Ports;

/// <summary>What is read of the simulated world.</summary>
internal sealed class WorldPort(SimulatedGame game) : IWorld
{
    public long GameFrame => game.GameFrame;

    public double TimeSeconds => game.World.TimeSeconds;

    public CameraState ReadCamera() => game.ReportedCamera;

    public EgoState ReadEgo() => game.World.EgoState;

    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range) => game.ReadEntities(centre, range);

    public EnvironmentState ReadEnvironment() => game.Environment;
}
