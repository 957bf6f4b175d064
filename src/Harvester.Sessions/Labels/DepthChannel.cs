using Harvester.Sessions.Files;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>The channel of depth maps: 16-bit greyscale PNG images in the units of docs/depth.md.</summary>
public sealed class DepthChannel : FrameChannel
{
    /// <inheritdoc />
    public override string Key => "depth";

    /// <inheritdoc />
    public override string FileKind => "depth map";

    /// <inheritdoc />
    public override IReadOnlyList<string> Folders { get; } = [FramePaths.DepthMaps, FramePaths.CompletedDepths, FramePaths.DepthErrors];

    /// <inheritdoc />
    public override ChannelSwitch Switch { get; } = new("Depth", "depth maps; with masks also completed ones and their estimated errors");

    /// <inheritdoc />
    public override string RaysKey => "depth";

    /// <inheritdoc />
    public override int? BitsPerPixel => 16;

    /// <inheritdoc />
    public override IChannelLabel? LabelIn(ChannelLabels labels) => labels?.Get<DepthLabel>();

    /// <inheritdoc />
    public override IChannelLabel Read(IJsonFields frame)
    {
        IJsonFields depth = frame.Fields(Key);
        return new DepthLabel(
            PictureName(depth, "sparse"),
            depth.Has("completed") ? PictureName(depth, "completed") : null,
            depth.Has("error") ? PictureName(depth, "error") : null,
            depth.Integer("raysCast"),
            depth.Integer("measuredPixels")
        );
    }

    internal override void Append(JsonText json, IChannelLabel label)
    {
        var depth = (DepthLabel)label;
        json.BeginObject()
            .Key("sparse")
            .String(depth.Sparse)
            .Key("completed")
            .String(depth.Completed)
            .Key("error")
            .String(depth.Error)
            .Key("raysCast")
            .Integer(depth.RaysCast)
            .Key("measuredPixels")
            .Integer(depth.MeasuredPixels)
            .EndObject();
    }
}
