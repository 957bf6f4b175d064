using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry.Work;
using Harvester.Sessions.SelfTests;

namespace Harvester.Capture.SelfTests;

/// <summary>
/// Harvests some frames with masks from photographs and from rays. The masks are compared with each other: do rays meet what is drawn? And
/// with the boxes of the cuboids: are the extents of models what is drawn?
/// </summary>
internal sealed class ShapeCheck(SelfTestContext context) : SelfCheck(context), IDisposable
{
    private const int Frames = 2;

    /// <summary>Masks from rays that meet the drawn shapes agree better than this with those from photographs.</summary>
    private const double MinIou = 0.75;

    /// <summary>Objects whose boxes are smaller, in pixels of height, are not measured.</summary>
    private const double MinHeightPixels = 16;

    /// <summary>Objects of which more is hidden are not measured.</summary>
    private const double MaxHidden = 0.02;

    /// <summary>The drawn shape fills at least this fraction of the height of its cuboid's box, as the median of the objects.</summary>
    private const double MinFilled = 0.82;

    private HarvestSession? _session;
    private FrameList? _sink;

    public override string Title => "rays, photographs and extents";

    public override IReadOnlyList<string> Checks => [SelfTestChecks.Rays, SelfTestChecks.Dimensions];

    public override IEnumerable<WorkStep> Run()
    {
        NeedPictures();
        if (Context.Lines.Any(line => line.Check == SelfTestChecks.Hiding && line.Verdict != SelfTestVerdict.Good))
        {
            throw new SelfTestException("objects cannot be hidden.");
        }

        if (Context.BestFreeze is not { } best)
        {
            throw new SelfTestException("no freeze method stops the world.");
        }

        _sink = new FrameList();
        _session = new HarvestSession(
            Context.Options with
            {
                Masks = true,
                MaskMethod = MaskMethod.Both,
                Freeze = true,
                FreezeBy = best.Method,
                Rig = null,
                Pairs = new PairOptions(),
                Channels = ChannelKeys.None,
                Semantics = null,
                Scenes = false,
                MaxFrames = Frames,
                ProbeLag = false,
                MaxCalibrationErrorPixels = null,
                MaxPictureLagTicks = Math.Min(Ports.PictureLag.MaxTicks, Context.PictureTicks),
                Lens = Context.MeasuredLens ?? Context.Options.Lens,
            },
            Game,
            _sink
        );
        while (!_session.Step().IsOver)
        {
            yield return WorkStep.Tick;
        }

        JudgeRays(_session);
        JudgeExtents(_sink.Frames);
        Context.AddUntested(Checks, _session.Fault ?? "no object is large enough in the picture.");
    }

    public void Dispose() => Release();

    public override void Release()
    {
        _session?.Dispose();
        _sink?.Dispose();
    }

    private void JudgeRays(HarvestSession session)
    {
        MaskAgreement[] classes = session.MaskComparison is { } comparison ? [.. comparison.Classes] : [];
        if (classes.Length > 0)
        {
            double mean = classes.Sum(each => each.MeanIou * each.Objects) / classes.Sum(each => each.Objects);
            string each = string.Join(", ", classes.Select(one => FormattableString.Invariant($"{one.Class} {one.MeanIou:0.00}")));
            Context.Add(
                SelfTestChecks.Rays,
                mean >= MinIou ? SelfTestVerdict.Good : SelfTestVerdict.Note,
                $"Masks from rays and from photographs agree by {mean:0.00} (IoU; {each})."
            );
        }
    }

    private void JudgeExtents(IReadOnlyList<CapturedFrame> frames)
    {
        double[] filled =
        [
            .. frames
                .SelectMany(frame => frame.Label.Objects)
                .Where(item =>
                    item is { Parent: null, TruncatedFraction: 0, OccludedFraction: <= MaxHidden, Box2DVisible: not null }
                    && item.Box2DAmodal.Height >= MinHeightPixels
                )
                .Select(item => item.Box2DVisible!.Value.Height / item.Box2DAmodal.Height)
                .OrderBy(value => value),
        ];
        if (filled.Length > 0)
        {
            double median = filled[filled.Length / 2];
            Context.Add(
                SelfTestChecks.Dimensions,
                median >= MinFilled ? SelfTestVerdict.Good : SelfTestVerdict.Problem,
                $"The drawn shapes of {filled.Length} objects fill {100 * median:0} % of the height of their cuboids' boxes."
            );
        }
    }

    private sealed class FrameList : IFrameSink
    {
        public List<CapturedFrame> Frames { get; } = [];

        public string? Fault => null;

        public int FirstFrame => 0;

        public int FirstObjectId => 1;

        public int FirstEventId => 1;

        public void Open(SessionStart start) { }

        public bool TryEnqueue(CapturedFrame frame)
        {
            Frames.Add(frame);
            return true;
        }

        public void Close(SessionEnd end) { }

        public void Dispose() => Frames.ForEach(frame => frame.Dispose());
    }
}
