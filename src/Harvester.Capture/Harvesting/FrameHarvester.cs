using Harvester.Capture.Labelling;
using Harvester.Geometry.Work;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Harvests frames in turn: takes a frame, labels what is visible in its image only, and hands it to the sink. While the image of a frame
/// is still being drawn, the next frames are taken; frames reach the sink in their order.
/// </summary>
internal sealed class FrameHarvester(
    HarvestOptions options,
    IFrameSink sink,
    ICaptureFlow flow,
    HarvestCounters counters,
    MotionRecorder? motion
)
{
    private readonly PictureQueue _drawing = new(options.Pairs.IsAny ? 0 : Math.Max(PictureQueue.UsualCapacity, options.ViewsPerMoment));
    private CapturedFrame? _ready;

    /// <summary>Watches the pictures of a single camera; null for a rig.</summary>
    public PictureWatch? Watch { get; init; }

    /// <summary>
    /// Harvests until the trigger has no more frames taken; each time one frame, or all views of one moment, which may be discarded. Ending
    /// the work resumes the game, and hands over the frames that the sink has room for.
    /// </summary>
    /// <param name="trigger">Says when to take a frame.</param>
    public IEnumerable<WorkStep> Run(IFrameTrigger trigger)
    {
        try
        {
            bool isOver = false;
            while (!isOver)
            {
                yield return WorkStep.Do(trigger.Await());

                isOver = !trigger.IsFrameDue;
                if (!isOver)
                {
                    yield return WorkStep.Do(flow.TakeFrame());

                    AwaitPictures();
                }

                // At the end, the frames that are left are handed over one a tick.
                while (isOver ? _drawing.Count > 0 : _drawing.IsOldestDue)
                {
                    if (isOver)
                    {
                        yield return HarvestPhase.WaitingForSink.Tick();
                    }

                    _ready = FinishOldest();
                    while (!sink.TryEnqueue(_ready))
                    {
                        counters.TicksWaitedForSink++;
                        yield return HarvestPhase.WaitingForSink.Tick();
                    }

                    _ready = null;
                    counters.Captured++;
                }

                if (!isOver)
                {
                    trigger.Leave();
                }
            }
        }
        finally
        {
            HandOverRest();
        }
    }

    /// <summary>Numbers the frames that the flow has taken, and queues them until their pictures are drawn.</summary>
    private void AwaitPictures()
    {
        if (flow.TakenSeconds is { } seconds && motion?.TakeBefore(seconds) is { } samples && flow.Taken.Count > 0)
        {
            flow.Taken[0].Motion = samples;
        }

        foreach (FrameDraft frame in flow.Taken)
        {
            _drawing.Add(sink.FirstFrame + counters.Taken, frame);
            counters.Taken++;
        }

        if (flow.IsPassed)
        {
            counters.Taken += options.ViewsPerMoment;
            counters.Captured += options.ViewsPerMoment;
        }
    }

    private void HandOverRest()
    {
        try
        {
            while (_ready is not null || _drawing.Count > 0)
            {
                _ready ??= FinishOldest();
                if (!sink.TryEnqueue(_ready))
                {
                    break;
                }

                _ready = null;
                counters.Captured++;
            }
        }
        finally
        {
            _ready?.Dispose();
            _ready = null;
            _drawing.Dispose();
        }
    }

    /// <summary>Waits for the picture of the oldest frame, and makes of both the frame that is written.</summary>
    private CapturedFrame FinishOldest()
    {
        (int number, FrameDraft draft) = _drawing.Remove();
        GrabbedPicture grabbed = draft.Picture!;
        PixelBuffer? picture = null;
        try
        {
            picture = grabbed.Take();
            LightObserver.Observe(draft, picture);
            Watch?.Add(draft.Camera.Pose.Position, picture);
            foreach (FramePart part in draft.Parts)
            {
                part.Complete(draft.Mask, picture);
            }

            var key = new FrameKey(number, draft.View?.Camera.Name, options.Format);
            SceneSnapshot snapshot = draft.Snapshot;
            int? place = options.Places?.PlaceOf(number);
            var label = new FrameLabel(
                number,
                snapshot.GameFrame,
                snapshot.TimeSeconds,
                draft.LagFrames,
                draft.LagSeconds,
                FramePaths.Image(number, options.Format, key.View),
                draft.Mask is null ? null : FramePaths.Mask(number, key.View),
                CameraLabel.Of(draft.Camera),
                EgoLabel.Of(snapshot.Ego),
                snapshot.Environment,
                draft.Objects
            )
            {
                Moment = draft.View?.MomentOf(number),
                View = key.View,
                Motion = draft.Motion,
                Place = place,
                PlaceFrame = place is { } at ? number - options.Places!.FirstFrameOf(at) : null,
                PixelMap = draft.PixelMap,
                Channels = draft.Parts.Aggregate(ChannelLabels.None, (labels, part) => labels.And(part.LabelIn(key))),
                Rays = draft.Rays,
                IgnoreRegions = draft.IgnoreRegions,
                Lanes = draft.Lanes,
            };
            return new CapturedFrame(label, picture, grabbed.Pool)
            {
                Mask = draft.Mask,
                Parts = draft.Parts,
                Files = [.. draft.Parts.SelectMany(part => part.FilesIn(key))],
                Folders = [.. draft.Parts.Select(part => part.FolderIn(key)).OfType<string>()],
                Scene = options.Scenes
                    ? new RecordedScene(snapshot, draft.Camera.Intrinsics.Lens, draft.Ids, draft.Occlusions) { Distant = draft.Distant }
                    : null,
            };
        }
        catch
        {
            // The session ends with the frame before; no later frame may follow.
            if (picture is not null)
            {
                grabbed.Pool.Return(picture);
            }

            grabbed.Dispose();
            _drawing.Dispose();
            throw;
        }
    }
}
