using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.Game;

/// <summary>Reads the simulated world.</summary>
internal sealed class WorldPort(SimulatedGame game) : IWorld
{
    public long GameFrame => game.GameFrame;

    public double TimeSeconds => game.World.TimeSeconds;

    public CameraState ReadCamera() => game.ReportedCamera;

    public EgoState ReadEgo() => game.World.EgoState;

    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range) => game.ReadEntities(centre, range);

    public EnvironmentState ReadEnvironment() => game.Environment;
}
