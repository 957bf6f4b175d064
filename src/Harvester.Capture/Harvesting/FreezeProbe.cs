using Harvester.Capture.Faults;
using Harvester.Capture.Ports;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Chooses the freeze method at the start of a harvest: each method is tried once, and the better one is used from then on.
/// </summary>
internal sealed class FreezeProbe(HarvestOptions options, GamePorts game, SceneReader reader, PixelBufferPool pool)
{
    private static readonly FreezeMethod[] Methods = [FreezeMethod.Paused, FreezeMethod.TimeScale];

    /// <summary>The findings of this session; null if the options give the method, and before the end.</summary>
    public FreezeReport? Report { get; private set; } = options.FreezeBy is null ? options.KnownFreezing : null;

    /// <summary>The warning if no method stops the world; otherwise null.</summary>
    public CaptureFault? Warning =>
        Report is { Used.HoldsWorld: false }
            ? new CaptureFault(
                FaultCode.NeverStill,
                "The world stood still neither while the game was paused nor at a time scale of 0, so most frames will be discarded. "
                    + "Remove mods that move the camera or the traffic."
            )
            : null;

    /// <summary>Sets the freeze method to the one in the options or, over several ticks, to the better one.</summary>
    public IEnumerable<WorkStep> Choose()
    {
        if ((options.FreezeBy ?? Report?.Method) is { } known)
        {
            game.Pause.Method = known;
            yield break;
        }

        var findings = new List<FreezeFinding>();
        foreach (FreezeMethod method in Methods)
        {
            game.Pause.Method = method;
            var trial = new FreezeTrial(options, game, reader, pool);
            yield return WorkStep.Do(trial.Run());

            findings.Add(trial.Finding);
        }

        Report = FreezeReport.Of(findings);
        game.Pause.Method = Report.Method;
    }
}
