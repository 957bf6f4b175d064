using Harvester.Capture.Events;
using Harvester.Capture.Labelling;
using Harvester.Geometry.Work;
using Harvester.Sessions.Events;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Harvests frames in turn: takes a frame, labels what is visible in its image only, and hands it to the sink. While the image of a frame
/// is still being drawn, the next frames are taken; frames reach the sink in their order.
/// </summary>
#pragma warning disable CA1001 // The queue is disposed when the work of Run ends.
internal sealed class FrameHarvester(
    HarvestOptions options,
    IFrameSink sink,
    ICaptureFlow flow,
    HarvestCounters counters,
    MotionRecorder? motion
)
#pragma warning restore CA1001
{
    private readonly PictureQueue _drawing = new(options.Pairs.IsAny ? 0 : Math.Max(PictureQueue.UsualCapacity, options.ViewsPerMoment));
    private readonly List<DrivingEvent> _lostEvents = [];
    private CapturedFrame? _ready;

    /// <summary>The events of frames that were given up, once the work has ended.</summary>
    public IReadOnlyList<DrivingEvent> LostEvents => _lostEvents;

    /// <summary>Holds frames back until it is known whether they are kept; null if all are.</summary>
    public FrameKeeper? Keeper { get; init; }

    /// <summary>Finds the events; null if they are not recorded.</summary>
    public EventRecorder? Events { get; init; }

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

                    Draw();
                    yield return WorkStep.Do(HandOver());
                }

                if (isOver && Keeper is not null)
                {
                    Keeper.IsEnding = true;
                    yield return WorkStep.Do(HandOver());
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
        motion?.GiveTo(flow, options.Motion);
        AddEvents();
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

    /// <summary>Gives the frames that the flow has taken their events.</summary>
    private void AddEvents()
    {
        if (Events is null || flow.TakenSeconds is not { } seconds)
        {
            return;
        }

        Events.Note(sink.FirstFrame + counters.Taken, options.ViewsPerMoment, seconds);
        if (flow.Taken.Count > 0)
        {
            TakenEvents events = Events.TakeAt(seconds);
            flow.Taken[0].EndedEvents = events.Ended;
            foreach (FrameDraft frame in flow.Taken)
            {
                frame.Events = events.Marks;
                frame.Spans = events.Spans;
            }
        }
    }

    /// <summary>Finishes the oldest frame; it is ready then, or held back.</summary>
    private void Draw()
    {
        CapturedFrame oldest = FinishOldest();
        if (Keeper is null)
        {
            _ready = oldest;
        }
        else
        {
            Keeper.Add(oldest);
        }
    }

    /// <summary>Hands over all frames that are ready.</summary>
    private IEnumerable<WorkStep> HandOver()
    {
        while (HasReady())
        {
            while (!TryHandOver())
            {
                counters.TicksWaitedForSink++;
                yield return HarvestPhase.WaitingForSink.Tick();
            }

            if (Keeper is { IsEnding: true })
            {
                yield return HarvestPhase.WaitingForSink.Tick();
            }
        }
    }

    private bool HasReady()
    {
        if (_ready is null && Keeper is not null)
        {
            int before = Keeper.Dropped;
            _ready = Keeper.Next();
            counters.Captured += Keeper.Dropped - before;
        }

        return _ready is not null;
    }

    private bool TryHandOver()
    {
        if (!sink.TryEnqueue(_ready!))
        {
            return false;
        }

        _ready = null;
        counters.Captured++;
        return true;
    }

    private void HandOverRest()
    {
        try
        {
            bool hasRoom = true;
            while (hasRoom && (HasReady() || _drawing.Count > 0))
            {
                if (HasReady())
                {
                    hasRoom = TryHandOver();
                }
                else
                {
                    Draw();
                }
            }
        }
        finally
        {
            _lostEvents.AddRange(_ready?.EndedEvents ?? []);
            _ready?.Dispose();
            _ready = null;
            _lostEvents.AddRange(Keeper?.GiveUp() ?? []);
            _lostEvents.AddRange(_drawing.Frames.SelectMany(static frame => frame.EndedEvents));
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
                Events = draft.Events,
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
                EndedEvents = draft.EndedEvents,
                Events = draft.Spans,
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
