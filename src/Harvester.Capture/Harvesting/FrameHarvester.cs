using Harvester.Capture.Events;
using Harvester.Capture.Labelling;
using Harvester.Geometry.Work;
using Harvester.Sessions.Events;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Harvests frames in turn: takes a frame, labels what is visible in its image only, and hands it to the sink. While the image of a frame
/// is still being drawn, the next frames are taken; frames reach the sink in their order. Disposing it hands over the frames that the sink
/// has room for.
/// </summary>
internal sealed class FrameHarvester(
    HarvestOptions options,
    IFrameSink sink,
    ICaptureFlow flow,
    HarvestCounters counters,
    MotionRecorder? motion
) : IDisposable
{
    private readonly PictureQueue _drawing = new(options.Pairs.IsAny ? 0 : Math.Max(PictureQueue.UsualCapacity, options.ViewsPerMoment));
    private readonly List<DrivingEvent> _lostEvents = [];
    private CapturedFrame? _ready;

    /// <summary>The events of frames that were given up, once this is disposed.</summary>
    public IReadOnlyList<DrivingEvent> LostEvents => _lostEvents;

    /// <summary>Holds frames back until it is known whether they are kept; null if all are.</summary>
    public FrameKeeper? Keeper { get; init; }

    /// <summary>Finds the events; null if they are not recorded.</summary>
    public EventRecorder? Events { get; init; }

    /// <summary>Watches the pictures of a single camera; null for a rig.</summary>
    public PictureWatch? Watch { get; init; }

    /// <summary>Harvests or discards one frame, or all views of one moment. Ending the work resumes the game.</summary>
    public IEnumerable<WorkStep> HarvestOne()
    {
        yield return WorkStep.Do(flow.TakeFrame());

        if (flow.TakenSeconds is { } seconds && motion?.TakeBefore(seconds) is { } samples && flow.Taken.Count > 0)
        {
            flow.Taken[0].Draft.Motion = samples;
        }

        AddEvents();
        foreach (TakenFrame frame in flow.Taken)
        {
            _drawing.Add(sink.FirstFrame + counters.Taken, frame);
            counters.Taken++;
        }

        if (flow.IsPassed)
        {
            counters.Taken += options.ViewsPerMoment;
            counters.Captured += options.ViewsPerMoment;
        }

        while (_drawing.IsOldestDue)
        {
            yield return WorkStep.Do(HandOver());
        }
    }

    /// <summary>Hands over the frames that are left, one a tick.</summary>
    public IEnumerable<WorkStep> Finish()
    {
        while (_drawing.Count > 0)
        {
            yield return HarvestPhase.WaitingForSink.Tick();
            yield return WorkStep.Do(HandOver());
        }

        Keeper?.IsEnding = true;
        yield return WorkStep.Do(HandOverReady());
    }

    /// <inheritdoc />
    public void Dispose()
    {
        try
        {
            while ((HasReady() && TryHandOver()) || (_ready is null && HasMore())) { }
        }
        finally
        {
            _lostEvents.AddRange(_ready?.EndedEvents ?? []);
            _ready?.Dispose();
            _ready = null;
            _lostEvents.AddRange(Keeper?.GiveUp() ?? []);
            _lostEvents.AddRange(_drawing.Frames.SelectMany(static frame => frame.Draft.EndedEvents));
            _drawing.Dispose();
        }
    }

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
            flow.Taken[0].Draft.EndedEvents = events.Ended;
            foreach (TakenFrame frame in flow.Taken)
            {
                frame.Draft.Events = events.Marks;
                frame.Draft.Spans = events.Spans;
            }
        }
    }

    private IEnumerable<WorkStep> HandOver()
    {
        Draw();
        yield return WorkStep.Do(HandOverReady());
    }

    private IEnumerable<WorkStep> HandOverReady()
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

    /// <summary>Takes the oldest drawn frame over.</summary>
    private void Draw()
    {
        CapturedFrame oldest = OldestFrame();
        if (Keeper is null)
        {
            _ready = oldest;
        }
        else
        {
            Keeper.Add(oldest);
        }
    }

    /// <summary>Takes over the next drawn frame, if there is one.</summary>
    private bool HasMore()
    {
        if (_drawing.Count == 0)
        {
            return false;
        }

        Draw();
        return true;
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

    private CapturedFrame OldestFrame()
    {
        (int number, TakenFrame taken) = _drawing.Remove();
        (FrameDraft draft, GrabbedPicture grabbed) = taken;
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

            FrameKey key = draft.KeyOf(number, options.Format);
            return new CapturedFrame(draft.Label(number, options.Format, options.Places), picture, grabbed.Pool)
            {
                Mask = draft.Mask,
                EndedEvents = draft.EndedEvents,
                Events = draft.Spans,
                Parts = draft.Parts,
                Files = [.. draft.Parts.SelectMany(part => part.FilesIn(key))],
                Folders = [.. draft.Parts.Select(part => part.FolderIn(key)).OfType<string>()],
                Scene = options.Scenes
                    ? new RecordedScene(draft.Snapshot, draft.Camera.Intrinsics.Lens, draft.Ids, draft.Occlusions)
                    {
                        Distant = draft.Distant,
                    }
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
