using Harvester.Geometry.Depth;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>The depth maps of a frame, in the units of docs/depth.md.</summary>
/// <param name="sparse">The depths that rays measured; 0 elsewhere.</param>
/// <param name="completed">The depths of all pixels; null without a mask.</param>
/// <param name="error">Their estimated errors; null without a mask.</param>
/// <param name="raysCast">The rays cast for them alone.</param>
public sealed class DepthMaps(InstanceMap sparse, InstanceMap? completed, InstanceMap? error, int raysCast) : FramePart
{
    /// <summary>The depths that rays measured; 0 elsewhere.</summary>
    public InstanceMap Sparse => sparse;

    /// <summary>The depths of all pixels; null without a mask.</summary>
    public InstanceMap? Completed => completed;

    /// <summary>Their estimated errors; null without a mask.</summary>
    public InstanceMap? Error => error;

    /// <summary>The estimate behind the maps, which has the values before they are rounded.</summary>
    public required DepthMap Estimate { get; init; }

    /// <inheritdoc />
    protected override IReadOnlyList<FileContent> Contents =>
        [Grey16(sparse), .. completed is { } depths && error is { } errors ? new[] { Grey16(depths), Grey16(errors) } : []];

    /// <inheritdoc />
    public override IChannelLabel LabelIn(FrameKey key) =>
        new DepthLabel(
            FramePaths.Depth(key.Frame, key.View),
            completed is null ? null : FramePaths.CompletedDepth(key.Frame, key.View),
            error is null ? null : FramePaths.DepthError(key.Frame, key.View),
            raysCast,
            sparse.Ids.Count(static depth => depth != 0)
        );
}
