using Harvester.Capture.Ports;
using Harvester.Geometry.Depth;
using Harvester.Geometry.Motion;
using Harvester.Geometry.Work;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Makes the flow between each frame of one view and the frame before, from the surfaces of both: as drawn, where the game knows what its
/// picture shows, else from rays and masks. docs/flow.md describes the maps.
/// </summary>
internal sealed class FlowLabeller(FrameRays rays, ISurfaceTruth? truth) : IChannelLabeller
{
    /// <summary>Rows that are made at once: about a millisecond's work for an image 800 pixels wide.</summary>
    private const int RowsAtOnce = 32;

    private PixelLines? _lines;
    private FlowMoment? _latest;
    private FlowMoment? _before;

    /// <inheritdoc />
    public ChannelTurn Turn => ChannelTurn.Last;

    /// <inheritdoc />
    public string RaysKey => FrameChannels.Flow.RaysKey;

    /// <inheritdoc />
    public IEnumerable<WorkStep> Label(FrameDraft draft, Func<bool> mayCastRays)
    {
        // A frame that was discarded after it was labelled is not the frame before.
        _before = _latest is { Frame.IsKept: true } ? _latest : _before;
        var read = new WorkResult<SurfaceMap>();
        int raysCast = rays.Counts.Of(RaysKey);
        yield return WorkStep.Do(Read(draft, mayCastRays, read));

        var now = new FlowMoment(draft, read.Value!);
        _latest = now;
        if (_before is not { } before || before.Frame.Number != draft.Before)
        {
            yield break;
        }

        var backward = new FlowMaker(now.Surfaces, before.Surfaces, handle => now.MotionTo(before, handle), hasMotion: true);
        var forward = new FlowMaker(before.Surfaces, now.Surfaces, handle => before.MotionTo(now, handle), hasMotion: false);
        foreach (FlowMaker maker in new[] { backward, forward })
        {
            int height = draft.Camera.Image.Height;
            for (int row = 0; row < height; row += RowsAtOnce)
            {
                maker.MakeRows(row, Math.Min(height, row + RowsAtOnce));
                yield return WorkStep.Pause;
            }
        }

        draft.Add(
            new FlowMaps(
                backward.Field,
                forward.Field,
                before.Frame.Number,
                truth is null ? SemanticsMethod.Rays : SemanticsMethod.Exact,
                rays.Counts.Of(RaysKey) - raysCast
            )
        );
    }

    private IEnumerable<WorkStep> Read(FrameDraft draft, Func<bool> mayCastRays, WorkResult<SurfaceMap> read)
    {
        _lines = _lines?.Intrinsics == draft.Camera.Intrinsics ? _lines : new PixelLines(draft.Camera.Intrinsics);
        if (truth is not null)
        {
            (float[] drawn, int[] handles) = truth.Surfaces(draft.Camera.Image);
            read.Value = new SurfaceMap(draft.Camera.Pose, _lines, drawn, handles);
            yield break;
        }

        var surfaces = new FrameSurfaces(rays, draft);
        yield return WorkStep.Do(surfaces.Sample(mayCastRays));

        DepthMap depths = surfaces.Complete();
        int pixels = draft.Camera.Image.PixelCount;
        (float[] metres, float[] errors, int[] entities) = (new float[pixels], new float[pixels], new int[pixels]);
        for (int at = 0; at < pixels; at++)
        {
            // A pixel shows the entity of the sample from which its depth is taken, which is one of the pixel's region of the mask.
            (metres[at], errors[at]) = ((float)depths.Metres[at], (float)depths.ErrorMetres[at]);
            entities[at] = depths.Sources[at] >= 0 ? surfaces.Samples[depths.Sources[at]].Entity : 0;
        }

        read.Value = new SurfaceMap(draft.Camera.Pose, _lines, metres, entities) { ErrorMetres = errors };
    }
}
