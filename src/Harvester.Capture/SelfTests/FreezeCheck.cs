using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry.Work;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.SelfTests;
using Harvester.Sessions.Text;

namespace Harvester.Capture.SelfTests;

/// <summary>Freezes the world once by one method, and observes what stands still and whether the camera can be moved.</summary>
internal sealed class FreezeCheck(SelfTestContext context, FreezeMethod method) : SelfCheck(context)
{
    /// <summary>Ticks for which the world must stand still, as in the choice of the freeze method at the start of a harvest.</summary>
    private const int StillTicks = 24;

    /// <summary>Ticks of the running world in which movement is looked for.</summary>
    private const int RunningTicks = 5;

    /// <summary>A world that takes longer to stand still makes each frame slower.</summary>
    private const int PromptTicks = 3;

    private readonly SceneComparison _comparison = new(context.Options.StillToleranceMetres);

    public override string Title => method == FreezeMethod.Paused ? "freezing by the game's pause" : "freezing by a time scale of 0";

    public override IReadOnlyList<string> Checks =>
        method == FreezeMethod.Paused
            ? [SelfTestChecks.FreezePaused, SelfTestChecks.EntitiesPaused, SelfTestChecks.SkyPaused, SelfTestChecks.CameraPaused]
            :
            [
                SelfTestChecks.FreezeTimeScale,
                SelfTestChecks.EntitiesTimeScale,
                SelfTestChecks.SkyTimeScale,
                SelfTestChecks.CameraTimeScale,
            ];

    private string World => Checks[0];

    private string Entities => Checks[1];

    private string Sky => Checks[2];

    private string Camera => Checks[3];

    public override IEnumerable<WorkStep> Run()
    {
        SceneSnapshot first = Context.Reader.Read();
        yield return WorkStep.Do(Wait(RunningTicks));

        SceneSnapshot anchor = Context.Reader.Read();
        bool sawMovement = _comparison.FirstDifference(first, anchor) is not null;
        Game.Pause.Method = method;
        Game.Pause.Freeze();
        int moved = 0;
        bool sameEntities = true;
        bool sameSky = true;
        int tick = 0;
        while (tick - moved < StillTicks && tick < Context.Options.MaxSettleTicks + StillTicks)
        {
            yield return WorkStep.Tick;
            tick++;
            SceneSnapshot now = Context.Reader.Read();
            (SceneSnapshot before, SceneSnapshot after) = Shared(anchor, now);
            if (_comparison.FirstDifference(before, after) is not null)
            {
                (anchor, moved, sameEntities, sameSky) = (now, tick, true, true);
            }

            sameEntities &= now.Entities.Count == anchor.Entities.Count && now.Entities.Count == after.Entities.Count;
            sameSky &= now.Environment == anchor.Environment;
        }

        bool holds = tick - moved >= StillTicks;
        Tell(holds, sawMovement, moved, sameEntities, sameSky);
        bool? movesCamera = null;
        if (holds && Game.MountedCamera is { } camera)
        {
            var shift = new CameraShift(Context);
            yield return WorkStep.Do(shift.Run(camera));

            movesCamera = shift.ReportedTicks is not null && (shift.SeenTicks is not null || !Context.ArePicturesUsable);
            Context.Add(
                Camera,
                movesCamera.Value ? SelfTestVerdict.Good : SelfTestVerdict.Problem,
                $"The camera can{(movesCamera.Value ? string.Empty : "not")} be moved while the world is frozen by {method}."
            );
        }

        Context.AddUntested(Checks, holds ? "the camera cannot be moved on a vehicle." : "the world did not stand still.");
        Context.Freezes.Add(
            new FreezeFinding(method, sawMovement, holds && sameEntities ? moved : null)
            {
                HoldsEnvironment = holds ? sameSky : null,
                MovesCamera = movesCamera,
            }
        );
    }

    private void Tell(bool holds, bool sawMovement, int moved, bool sameEntities, bool sameSky)
    {
        if (!holds)
        {
            Context.Add(World, SelfTestVerdict.Problem, $"{method} does not stop the world.");
            return;
        }

        string doubt = sawMovement ? string.Empty : " Nothing had moved before, so this proves little: repeat the test in traffic.";
        Context.Add(
            World,
            moved <= PromptTicks ? SelfTestVerdict.Good : SelfTestVerdict.Note,
            $"{method} stops the world after {Counted.Of(moved, "tick")}.{doubt}"
        );
        Context.Add(
            Entities,
            sameEntities ? SelfTestVerdict.Good : SelfTestVerdict.Problem,
            $"{(sameEntities ? "The same entities exist" : "Entities appear and disappear")} while the world is frozen by {method}."
        );
        Context.Add(
            Sky,
            sameSky ? SelfTestVerdict.Good : SelfTestVerdict.Problem,
            $"Weather and time of day {(sameSky ? "stand still" : "go on")} while the world is frozen by {method}."
        );
    }

    /// <summary>Both readings with the entities that both have.</summary>
    private static (SceneSnapshot Before, SceneSnapshot After) Shared(SceneSnapshot before, SceneSnapshot after)
    {
        var shared = new HashSet<int>(before.Entities.Select(entity => entity.Handle));
        shared.IntersectWith(after.Entities.Select(entity => entity.Handle));
        return (With(before), With(after));

        SceneSnapshot With(SceneSnapshot scene) =>
            scene with
            {
                Entities = [.. scene.Entities.Where(entity => shared.Contains(entity.Handle))],
            };
    }
}
