using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Work;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Doubles;

/// <summary>The world of a game in which a reading of the entities takes several ticks.</summary>
internal sealed class SlowWorld(FakeGame game, int ticks) : IStepwiseWorld
{
    /// <summary>A step takes longer than any budget.</summary>
    private const double MillisecondsOfAStep = 1000;

    public long GameFrame => game.GameFrame;

    public double TimeSeconds => game.TimeSeconds;

    public CameraState ReadCamera() => game.ReadCamera();

    public EgoState ReadEgo() => game.ReadEgo();

    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range) => game.ReadEntities(centre, range);

    public IEnumerable<WorkStep> ReadEntitiesInSteps(Vector3D centre, double range, List<EntityState> entities)
    {
        for (int step = 0; step < ticks; step++)
        {
            game.Work(MillisecondsOfAStep);
            yield return WorkStep.Pause;
        }

        foreach (EntityState entity in game.ReadEntities(centre, range))
        {
            entities.Add(entity);
            yield return WorkStep.Pause;
        }
    }

    public EnvironmentState ReadEnvironment() => game.ReadEnvironment();
}
