using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Freeze, read until nothing moves, grab, label, read again, unfreeze. The picture may lag some frames behind the state. Since the state
/// has been the same for at least that many frames when the picture is grabbed, and still is when its labels are done, the picture shows
/// what the labels say, whichever of those frames it shows.
/// </summary>
/// <remarks>
/// A reading may take several ticks. The frames for which the state has been the same count from the end of the first of equal readings:
/// every entity was read before, and is read again after the picture was grabbed.
/// </remarks>
internal sealed class FrozenFlow(
    HarvestOptions options,
    GamePorts game,
    SceneReader reader,
    FrameLabeller labeller,
    PixelBufferPool pool,
    TickBudget budget,
    HarvestCounters counters,
    PhaseCalls calls,
    CodedPhotographer? photographer,
    PairPhotographer? pairs
) : ICaptureFlow
{
    private readonly FrozenScene _scene = new(options, reader, budget, counters, calls);

    public IReadOnlyList<TakenFrame> Taken { get; private set; } = [];

    public bool IsPassed { get; private set; }

    public double? TakenSeconds { get; private set; }

    /// <summary>
    /// Whether the next frame is to be taken. One of another shard, or one that the session already holds, is read and settled too, but not
    /// grabbed or labelled.
    /// </summary>
    public required Func<bool> TakesNext { get; init; }

    public IEnumerable<HarvestPhase> TakeFrame()
    {
        Taken = [];
        IsPassed = false;
        TakenSeconds = null;
        bool isOurs = TakesNext();
        GrabbedPicture? picture = null;
        game.Pause.Freeze();
        try
        {
            foreach (HarvestPhase phase in _scene.Settle())
            {
                yield return phase;
            }

            if (_scene.Settled is not { } snapshot)
            {
                yield break;
            }

            picture = isOurs ? GrabbedPicture.Of(game.Screen, pool) : null;
            if (picture?.Refusal is { } refusal)
            {
                counters.Discard(refusal);
                yield break;
            }

            if (photographer is not null)
            {
                foreach (
                    HarvestPhase phase in photographer.Take(
                        labeller.CameraOf(snapshot),
                        labeller.TargetsOf(snapshot),
                        picture?.WaitForPixels()
                    )
                )
                {
                    yield return phase;
                }

                calls.Charge(HarvestPhase.Photographing);
                if (photographer.Refusal is { } failed)
                {
                    counters.Discard(failed);
                    yield break;
                }
            }

            FrameDraft? draft = null;
            budget.BeginSteps();
            if (!isOurs)
            {
                labeller.Pass(snapshot);
            }

            foreach (FrameDraft? slice in isOurs ? labeller.Label(snapshot, static () => true, photographer?.Pictures) : [])
            {
                draft = slice;
                if (slice is null && budget.IsSpent)
                {
                    yield return HarvestPhase.Labelling;
                }
            }

            if (pairs is not null)
            {
                photographer?.Release();
                foreach (HarvestPhase phase in isOurs ? pairs.Take(draft!, picture!.WaitForPixels()) : pairs.Pass())
                {
                    yield return phase;
                }

                calls.Charge(HarvestPhase.Photographing);
            }

            foreach (HarvestPhase phase in _scene.Read(HarvestPhase.Labelling))
            {
                yield return phase;
            }

            if (_scene.Comparison.FirstDifference(snapshot, _scene.Latest!) is { } difference)
            {
                counters.Discard(difference);
                yield break;
            }

            IsPassed = !isOurs;
            TakenSeconds = snapshot.TimeSeconds;
            if (isOurs)
            {
                if (pairs is { Taken: { Count: > 0 } pictures })
                {
                    draft!.Add(new PairPictures(pictures));
                }

                Taken = [new TakenFrame(draft!, picture!)];
                picture = null;
            }
        }
        finally
        {
            picture?.Dispose();
            photographer?.Release();
            pairs?.Release();
            game.Pause.Unfreeze();
            calls.Charge(HarvestPhase.Labelling);
        }
    }
}
