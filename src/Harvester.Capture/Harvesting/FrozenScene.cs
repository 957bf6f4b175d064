using Harvester.Capture.Ports;
using Harvester.Geometry.Work;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>The scene of a frozen game: waits until it stands still, and reads it again to see that it still does.</summary>
internal sealed class FrozenScene(HarvestOptions options, IWorld world, SceneReader reader, PhaseCalls calls)
{
    /// <summary>The latest reading; null if the scene kept moving.</summary>
    public SceneSnapshot? Latest { get; private set; }

    /// <summary>Game frames until the scene of the latest reading stood still.</summary>
    public int MovingTicks { get; private set; }

    /// <summary>The comparison of readings.</summary>
    public SceneComparison Comparison { get; } = new(options.StillToleranceMetres);

    /// <summary>
    /// Reads the scene into <see cref="Latest"/>, until nothing has moved for a number of game frames. Each reading may take several ticks.
    /// </summary>
    /// <param name="phase">The phase of the harvest meanwhile.</param>
    /// <param name="stillTicks">The number of game frames; 0 to read the scene once.</param>
    public IEnumerable<WorkStep> Read(HarvestPhase phase, int stillTicks)
    {
        var gate = new StillnessGate(Comparison);
        for (int readings = 0; readings == 0 || gate.StillTicks < stillTicks; readings++)
        {
            if (readings > options.MaxSettleTicks + stillTicks)
            {
                Latest = null;
                yield break;
            }

            if (readings > 0)
            {
                yield return phase.Tick();
            }

            CameraState camera = world.ReadCamera();
            var entities = new List<EntityState>();
            if (world is IStepwiseWorld stepwise)
            {
                yield return phase.Do(stepwise.ReadEntitiesInSteps(reader.CentreFor(camera), reader.RangeMetres, entities));
            }
            else
            {
                entities.AddRange(world.ReadEntities(reader.CentreFor(camera), reader.RangeMetres));
            }

            Latest = reader.SnapshotOf(camera, entities);
            calls.Charge(phase);
            gate.Observe(Latest);
        }

        MovingTicks = (int)gate.MovingTicks;
    }
}
