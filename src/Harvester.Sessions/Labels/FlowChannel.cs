using Harvester.Sessions.Files;
using Harvester.Sessions.Semantics;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>The channel of dense motion between consecutive frames of a view: maps in the numbers of docs/flow.md.</summary>
public sealed class FlowChannel : FrameChannel
{
    private const string BackwardFolder = "flow-backward";
    private const string ForwardFolder = "flow-forward";
    private const string MotionFolder = "flow-motion";
    private const string BackwardFlagsFolder = "flow-backward-flags";
    private const string ForwardFlagsFolder = "flow-forward-flags";
    private const int BitsOfVectors = 48;
    private const int BitsOfFlags = 8;
    private const int ErrorDecimals = 3;

    /// <inheritdoc />
    public override string Key => "flow";

    /// <inheritdoc />
    public override string FileKind => "map of flow";

    /// <inheritdoc />
    public override IReadOnlyList<string> Folders { get; } =
    [BackwardFolder, ForwardFolder, MotionFolder, BackwardFlagsFolder, ForwardFlagsFolder];

    /// <inheritdoc />
    public override string RaysKey => Key;

    /// <inheritdoc />
    public override ChannelSwitch Switch { get; } =
        new("Flow", "optical flow to and from the frame before, the motion of the surfaces, and what is visible in both");

    /// <summary>The paths of the maps of a frame.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="view">The view of a rig; null without a rig.</param>
    public static FlowFiles FilesOf(int frame, string? view) =>
        new(
            FramePaths.Map(BackwardFolder, frame, view),
            FramePaths.Map(ForwardFolder, frame, view),
            FramePaths.Map(MotionFolder, frame, view),
            FramePaths.Map(BackwardFlagsFolder, frame, view),
            FramePaths.Map(ForwardFlagsFolder, frame, view)
        );

    /// <inheritdoc />
    public override int? BitsOf(IChannelLabel label, string file) =>
        label is FlowLabel { Maps: { } maps } && (file == maps.BackwardFlags || file == maps.ForwardFlags) ? BitsOfFlags : BitsOfVectors;

    /// <inheritdoc />
    public override IChannelLabel? LabelIn(ChannelLabels labels) => labels?.Get<FlowLabel>();

    /// <inheritdoc />
    public override bool OutlivesLens(IChannelLabel label) => false;

    /// <inheritdoc />
    public override IChannelLabel Read(IJsonFields frame)
    {
        IJsonFields flow = frame.Fields(Key);
        return new FlowLabel(
            flow.Integer("from"),
            flow.Name<SemanticsMethod>("method"),
            new FlowFiles(
                PictureName(flow, "backward"),
                PictureName(flow, "forward"),
                PictureName(flow, "motion"),
                PictureName(flow, "backwardFlags"),
                PictureName(flow, "forwardFlags")
            )
        )
        {
            ErrorPixels = flow.Has("errorPixels") ? flow.Number("errorPixels") : null,
            RaysCast = flow.Integer("raysCast"),
        };
    }

    internal override void Append(JsonText json, IChannelLabel label)
    {
        var flow = (FlowLabel)label;
        json.BeginObject()
            .Key("from")
            .Integer(flow.From)
            .Key("method")
            .String(JsonName.Of(flow.Method))
            .Key("backward")
            .String(flow.Maps.Backward)
            .Key("forward")
            .String(flow.Maps.Forward)
            .Key("motion")
            .String(flow.Maps.Motion)
            .Key("backwardFlags")
            .String(flow.Maps.BackwardFlags)
            .Key("forwardFlags")
            .String(flow.Maps.ForwardFlags);
        if (flow.ErrorPixels is { } error)
        {
            json.Key("errorPixels").Number(error, ErrorDecimals);
        }

        json.Key("raysCast").Integer(flow.RaysCast).EndObject();
    }
}
