using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Work;
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
    private readonly FrozenScene _scene = new(options, game.World, reader, calls);

    public IReadOnlyList<FrameDraft> Taken { get; private set; } = [];

    public bool IsPassed { get; private set; }

    public double? TakenSeconds { get; private set; }

    /// <summary>Says what is to be done with the next frame.</summary>
    public required Func<FrameTurn> NextTurn { get; init; }

    public IEnumerable<WorkStep> TakeFrame()
    {
        Taken = [];
        IsPassed = false;
        TakenSeconds = null;
        FrameTurn turn = NextTurn();
        GrabbedPicture? picture = null;
        game.Pause.Freeze();
        try
        {
            yield return WorkStep.Do(_scene.Read(HarvestPhase.Settling, options.MaxPictureLagTicks));

            if (_scene.Latest is not { } snapshot)
            {
                counters.Discard("neverStill");
                yield break;
            }

            counters.Settled(_scene.MovingTicks);
            picture = turn.IsLabelled ? new GrabbedPicture(game.Screen, pool) : null;
            if (picture?.Refusal is { } refusal)
            {
                counters.Discard(refusal);
                yield break;
            }

            Camera camera = labeller.CameraOf(snapshot);
            var frame = new FrameDraft(snapshot, camera, labeller.CandidatesOf(camera, snapshot))
            {
                Number = turn.Number,
                Before = turn.Before,
            };
            if (photographer is not null)
            {
                yield return HarvestPhase.Photographing.Do(photographer.Take(camera, frame.Targets, picture?.WaitForPixels()));

                calls.Charge(HarvestPhase.Photographing);
                if (photographer.Refusal is { } failed)
                {
                    counters.Discard(failed);
                    yield break;
                }
            }

            budget.BeginSteps();
            if (turn.IsLabelled)
            {
                yield return HarvestPhase.Labelling.Do(labeller.Label(frame, static () => true, photographer?.Pictures));
            }
            else
            {
                labeller.Pass(frame);
            }

            if (pairs is not null)
            {
                photographer?.Release();
                yield return HarvestPhase.Photographing.Do(turn.IsOurs ? pairs.Take(frame, picture!.WaitForPixels()) : pairs.Pass());

                calls.Charge(HarvestPhase.Photographing);
            }

            yield return WorkStep.Do(_scene.Read(HarvestPhase.Labelling, stillTicks: 0));

            if (_scene.Comparison.FirstDifference(snapshot, _scene.Latest!) is { } difference)
            {
                counters.Discard(difference);
                yield break;
            }

            IsPassed = !turn.IsOurs;
            frame.IsKept = true;
            TakenSeconds = snapshot.TimeSeconds;
            if (turn.IsOurs)
            {
                if (pairs is { Taken: { Count: > 0 } pictures })
                {
                    frame.Add(new PairPictures(pictures));
                }

                (frame.Picture, picture) = (picture, null);
                Taken = [frame];
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
