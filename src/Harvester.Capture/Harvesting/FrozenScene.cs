using Harvester.Geometry.Work;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>The scene of a frozen game: waits until it stands still, and reads it again to see that it still does.</summary>
internal sealed class FrozenScene(HarvestOptions options, SceneReader reader, HarvestCounters counters, PhaseCalls calls)
{
    private readonly SceneComparison _comparison = new(options.StillToleranceMetres);
    private readonly WorkResult<SceneSnapshot> _read = new();

    /// <summary>The latest reading.</summary>
    public SceneSnapshot? Latest { get; private set; }

    /// <summary>The scene that stood still; null if it kept moving, which discards the frame.</summary>
    public SceneSnapshot? Settled { get; private set; }

    /// <summary>The comparison of readings.</summary>
    public SceneComparison Comparison => _comparison;

    /// <summary>Reads until nothing has moved for as long as a picture may lag.</summary>
    public IEnumerable<WorkStep> Settle()
    {
        Settled = null;
        var gate = new StillnessGate(_comparison);
        for (int readings = 0; readings == 0 || gate.StillTicks < options.MaxPictureLagTicks; readings++)
        {
            if (readings > options.MaxSettleTicks + options.MaxPictureLagTicks)
            {
                counters.Discard("neverStill");
                yield break;
            }

            if (readings > 0)
            {
                yield return HarvestPhase.Settling.Tick();
            }

            yield return WorkStep.Do(Read(HarvestPhase.Settling));

            gate.Observe(Latest!);
        }

        Settled = Latest;
        counters.Settled((int)gate.MovingTicks);
    }

    /// <summary>Reads the scene into <see cref="Latest"/>, which may take several ticks.</summary>
    /// <param name="phase">The phase of the harvest meanwhile.</param>
    public IEnumerable<WorkStep> Read(HarvestPhase phase)
    {
        yield return phase.Do(reader.ReadInSteps(_read));
        Latest = _read.Value;
        calls.Charge(phase);
    }
}
