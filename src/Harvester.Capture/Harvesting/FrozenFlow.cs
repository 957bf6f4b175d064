using System;
using System.Collections.Generic;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Freeze, settle, snapshot, grab, read again, label, unfreeze. The picture may lag some frames behind the state. Since the state has been
/// the same for at least that many frames when the picture is grabbed, and still is when its labels are done, the picture shows what the
/// labels say, whichever of those frames it shows.
/// </summary>
internal sealed class FrozenFlow(
    HarvestOptions options,
    GamePorts game,
    SceneReader reader,
    FrameLabeller labeller,
    PixelBufferPool pool,
    TickBudget budget,
    HarvestCounters counters,
    PhaseCalls calls)
    : ICaptureFlow
{
    private readonly SceneComparison _comparison = new(options.StillToleranceMetres);

    public FrameDraft? Draft { get; private set; }

    public bool IsPassed { get; private set; }

    /// <summary>
    /// Whether the next frame belongs to this shard. A frame of another shard is read and settled too, but not grabbed or labelled.
    /// </summary>
    public required Func<bool> TakesNext { get; init; }

    public IEnumerable<HarvestPhase> TakeFrame()
    {
        Draft = null;
        IsPassed = false;
        bool isOurs = TakesNext();
        PixelBuffer? picture = pool.Rent();
        game.Pause.Freeze();
        try
        {
            var gate = new StillnessGate(_comparison);
            SceneSnapshot snapshot = reader.Read();
            gate.Observe(snapshot);
            calls.Charge(HarvestPhase.Settling);
            long firstGameFrame = snapshot.GameFrame;
            for (int ticks = 0; gate.StillTicks < options.MaxPictureLagTicks; ticks++)
            {
                if (ticks == options.MaxSettleTicks + options.MaxPictureLagTicks)
                {
                    counters.Discard("neverStill");
                    yield break;
                }

                yield return HarvestPhase.Settling;
                snapshot = reader.Read();
                gate.Observe(snapshot);
                calls.Charge(HarvestPhase.Settling);
            }

            counters.Settled((int)(snapshot.GameFrame - gate.StillTicks - firstGameFrame));
            if (isOurs && game.Screen.Grab(picture).Refusal is { } refusal)
            {
                counters.Discard(refusal);
                yield break;
            }

            if (_comparison.FirstDifference(snapshot, reader.Read()) is { } duringGrab)
            {
                counters.Discard(duringGrab);
                yield break;
            }

            FrameDraft? draft = null;
            if (!isOurs)
            {
                labeller.Pass(snapshot);
            }

            foreach (FrameDraft? slice in isOurs ? labeller.Label(snapshot, static () => true) : [])
            {
                draft = slice;
                if (slice is null && budget.IsSpent)
                {
                    yield return HarvestPhase.Labelling;
                }
            }

            if (_comparison.FirstDifference(snapshot, reader.Read()) is { } duringLabelling)
            {
                counters.Discard(duringLabelling);
                yield break;
            }

            IsPassed = !isOurs;
            if (isOurs)
            {
                draft!.Picture = picture;
                Draft = draft;
                picture = null;
            }
        }
        finally
        {
            if (picture is not null)
            {
                pool.Return(picture);
            }

            game.Pause.Unfreeze();
            calls.Charge(HarvestPhase.Labelling);
        }
    }
}
