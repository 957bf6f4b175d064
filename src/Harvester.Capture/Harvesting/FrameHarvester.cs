using System.Collections.Generic;
using Harvester.Capture.Labelling;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>Harvests one frame after the other: takes it, labels what only the picture tells, and hands it to the sink.</summary>
internal sealed class FrameHarvester(
    HarvestOptions options, IFrameSink sink, ICaptureFlow flow, PixelBufferPool pool, HarvestCounters counters)
{
    /// <summary>Harvests one frame, or comes to discard it. Disposing the sequence leaves the game running.</summary>
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
