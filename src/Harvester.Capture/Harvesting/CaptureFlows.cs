using Harvester.Capture.Faults;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Rigs;

namespace Harvester.Capture.Harvesting;

/// <summary>Creates the flow with which a harvest takes its frames, of a frozen game or of a live one.</summary>
internal sealed class CaptureFlows(
    HarvestOptions options,
    GamePorts game,
    SceneReader reader,
    PixelBufferPool pool,
    TickBudget budget,
    HarvestCounters counters,
    PhaseCalls calls
)
{
    private readonly bool _needsFrameBefore = CaptureChannels.Of(options).Any(static channel => channel.NeedsFrameBefore);

    /// <summary>Creates the flow for a sink.</summary>
    /// <param name="sink">Receives the frames; it gives the numbers of the first frame and object.</param>
    /// <param name="lag">The picture lag; null if it is unknown.</param>
    /// <exception cref="HarvestFaultException">The harvest is live, and the lag is unknown.</exception>
    public ICaptureFlow For(IFrameSink sink, PictureLag? lag)
    {
        ObjectRegistry registry = Registry = new ObjectRegistry(sink.FirstObjectId);
        FrameRays rays = CaptureChannels.Of(options).Any(channel => channel.NeedsNormals(game))
            ? new FrameRays(game.SurfaceRays!, options.RayBudget) { Record = new RayRecord() }
            : new FrameRays(game.Rays, options.RayBudget);
        LaneLabeller? lanes = game.Roads is { } roads ? new LaneLabeller(roads, game.Paint, rays, registry) : null;
        if (options.Rig is { } rig)
        {
            return new RigFlow(
                options,
                game,
                reader,
                rig,
                camera => LabellerOf(OptionsOf(camera), registry, rays, lanes),
                registry,
                budget,
                counters,
                calls
            )
            {
                NextTurn = () => TurnOf(sink.FirstFrame + counters.Taken),
            };
        }

        FrameLabeller labeller = LabellerOf(options, registry, rays, lanes);
        return options.Freeze
            ? new FrozenFlow(options, game, reader, labeller, pool, budget, counters, calls, Photographer, Pairs)
            {
                NextTurn = () => TurnOf(sink.FirstFrame + counters.Taken),
            }
            : new LiveFlow(game, reader, labeller, pool, budget, counters, NextLag ?? Always(lag ?? throw LagUnknown()));
    }

    /// <summary>Takes the pictures for coded masks; null if there are none.</summary>
    public CodedPhotographer? Photographer { get; } =
        options is { Masks: true, MaskMethod: not MaskMethod.Rays } ? new CodedPhotographer(game, pool, options.MaxPictureLagTicks) : null;

    /// <summary>Takes the further pictures of moments; null if there are none.</summary>
    public PairPhotographer? Pairs { get; } = options.Pairs.IsAny ? new PairPhotographer(options, game, pool) : null;

    /// <summary>Compares masks of both methods; null if they are not compared.</summary>
    public MaskComparison? Comparison { get; } = options is { Masks: true, MaskMethod: MaskMethod.Both } ? new MaskComparison() : null;

    /// <summary>The ids of the objects; null until there is a flow.</summary>
    public ObjectRegistry? Registry { get; private set; }

    /// <summary>Gives the picture lag of the next live frame; null if it is always the same.</summary>
    public Func<PictureLag>? NextLag { get; init; }

    private static Func<PictureLag> Always(PictureLag lag) => () => lag;

    private FrameTurn TurnOf(int frame)
    {
        int views = options.ViewsPerMoment;
        bool isOurs = Takes(frame);
        bool isNeeded = _needsFrameBefore && Takes(frame + views) && IsOneCourse(frame, frame + views);
        return new FrameTurn(
            frame,
            frame >= views && IsOneCourse(frame - views, frame) ? frame - views : null,
            isOurs,
            IsLabelled: isOurs || isNeeded
        );
    }

    private bool IsOneCourse(int frame, int next) => options.Places is not { } places || places.PlaceOf(frame) == places.PlaceOf(next);

    private bool Takes(int frame) => frame > options.RecordedThrough && options.Shard.Takes(frame / options.ViewsPerMoment);

    private static HarvestFaultException LagUnknown() =>
        new(
            new CaptureFault(
                FaultCode.LagUnknown,
                "The picture lag could not be measured, because nothing moved in view while the live harvest started. "
                    + "Drive on and start again, or freeze the game for each frame."
            )
        );

    private HarvestOptions OptionsOf(RigCamera camera) => options with { Image = camera.Image, Lens = camera.Lens };

    private FrameLabeller LabellerOf(HarvestOptions of, ObjectRegistry registry, FrameRays rays, LaneLabeller? lanes) =>
        new(of, rays, registry)
        {
            Comparison = Comparison,
            Lanes = lanes,
            Channels = [.. CaptureChannels.Of(of).Select(channel => channel.LabellerFor(of, rays, game)).OfType<IChannelLabeller>()],
            Faces = of.Faces is { } faces ? new FaceLabeller(faces, of, rays, game.Lights, registry) : null,
            DrawnOcclusion = game.DrawnOcclusion,
        };
}
