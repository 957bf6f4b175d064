using System.Collections.Generic;
using Harvester.Capture.Labelling;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>Harvests frames in turn: takes a frame, labels what is visible in its image only, and hands it to the sink.</summary>
internal sealed class FrameHarvester(
    HarvestOptions options, IFrameSink sink, ICaptureFlow flow, PixelBufferPool pool, HarvestCounters counters)
{
    /// <summary>Harvests or discards one frame. Disposing the sequence resumes the game.</summary>
    public IEnumerable<HarvestPhase> HarvestOne()
    {
        foreach (HarvestPhase phase in flow.TakeFrame())
        {
            yield return phase;
        }

        if (flow.Draft is { } draft)
        {
            CapturedFrame frame = FrameOf(draft);
            while (!sink.TryEnqueue(frame))
            {
                counters.TicksWaitedForSink++;
                yield return HarvestPhase.WaitingForSink;
            }

            counters.Captured++;
        }
        else if (flow.IsPassed)
        {
            counters.Captured++;
        }
    }

    private CapturedFrame FrameOf(FrameDraft draft)
    {
        PixelBuffer picture = draft.Picture!;
        LightObserver.Observe(draft, picture);
        return new CapturedFrame(draft.Label(sink.FirstFrame + counters.Captured, options.Format), picture, draft.Mask, pool)
        {
            Scene = options.Scenes
                ? new RecordedScene(draft.Snapshot, options.Lens, draft.Ids, draft.Occlusions) { Distant = draft.Distant }
                : null,
        };
    }
}
