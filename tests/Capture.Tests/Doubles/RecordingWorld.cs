using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Tests.Doubles;

/// <summary>Records which entities are requested.</summary>
internal sealed class RecordingWorld(IWorld world, List<(Vector3D Centre, double Range)> asked) : IWorld
{
    public long GameFrame => world.GameFrame;

    public double TimeSeconds => world.TimeSeconds;

    public CameraState ReadCamera() => world.ReadCamera();

    public EgoState ReadEgo() => world.ReadEgo();

    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range)
    {
        asked.Add((centre, range));
        return world.ReadEntities(centre, range);
    }

    public EnvironmentState ReadEnvironment() => world.ReadEnvironment();
}
