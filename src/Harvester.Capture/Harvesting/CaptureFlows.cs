using Harvester.Capture.Faults;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>Creates the flow with which a harvest takes its frames, of a frozen game or of a live one.</summary>
internal sealed class CaptureFlows(
    HarvestOptions options, GamePorts game, SceneReader reader, PixelBufferPool pool, TickBudget budget, HarvestCounters counters,
        PhaseCalls calls)
{
    /// <summary>Creates the flow for a sink.</summary>
    /// <param name="sink">Receives the frames; it gives the numbers of the first frame and object.</param>
    /// <param name="lag">The picture lag; null if it is unknown.</param>
    /// <exception cref="HarvestFaultException">The harvest is live, and the lag is unknown.</exception>
    public ICaptureFlow For(IFrameSink sink, PictureLag? lag)
    {
        FrameLabeller labeller = LabellerFrom(sink.FirstObjectId);
        return options.Freeze
            ? new FrozenFlow(options, game, reader, labeller, pool, budget, counters, calls, Photographer)
            {
                TakesNext = () => Takes(sink.FirstFrame + counters.Taken),
            }
            : new LiveFlow(game, reader, labeller, pool, budget, counters, lag ?? throw LagUnknown());
    }

    /// <summary>Takes the pictures for coded masks; null if there are none.</summary>
    public CodedPhotographer? Photographer { get; } =
        options is { Masks: true, MaskMethod: not MaskMethod.Rays } ? new CodedPhotographer(game, pool, options.MaxPictureLagTicks) : null;

    /// <summary>Compares masks of both methods; null if they are not compared.</summary>
    public MaskComparison? Comparison { get; } = options is { Masks: true, MaskMethod: MaskMethod.Both } ? new MaskComparison() : null;

    private bool Takes(int frame) => frame > options.RecordedThrough && options.Shard.Takes(frame);

    private static HarvestFaultException LagUnknown() =>
        new(new CaptureFault(
            FaultCode.LagUnknown,
            "The picture lag could not be measured, because nothing moved in view while the live harvest started. "
            + "Drive on and start again, or freeze the game for each frame."));

    private FrameLabeller LabellerFrom(int firstObjectId)
    {
        var registry = new ObjectRegistry(firstObjectId);
        var rays = new FrameRays(game.Rays, options.RayBudget);
        return new FrameLabeller(options, rays, registry)
        {
            Comparison = Comparison,
            Lanes = game.Roads is { } roads ? new LaneLabeller(roads, game.Paint, rays, registry) : null,
            Semantics = options.Semantics is null ? null : new SemanticLabeller(options, rays, game.Paint, game.Surfaces),
            Faces = options.Faces is { } faces ? new FaceLabeller(faces, options, rays, game.Lights, registry) : null,
            DrawnOcclusion = game.DrawnOcclusion,
        };
    }
}
