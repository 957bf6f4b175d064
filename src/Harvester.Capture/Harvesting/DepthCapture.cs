using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>Depth maps, from rays; completed ones need masks.</summary>
internal sealed class DepthCapture() : CaptureChannel(FrameChannels.Depth)
{
    /// <inheritdoc />
    public override bool NeedsNormals(GamePorts game) => true;

    /// <inheritdoc />
    public override string? ProblemFor(HarvestOptions options, GamePorts game) =>
        options.Freeze && game.SurfaceRays is not null ? null : "Depth maps need a game that is frozen for each frame and reports normals.";

    /// <inheritdoc />
    public override IEnumerable<string> FoldersFor(HarvestOptions options) =>
        options.Masks ? base.FoldersFor(options) : WithViews([FramePaths.DepthMaps], options);

    /// <inheritdoc />
    public override IChannelLabeller LabellerFor(LabellingOptions options, FrameRays rays, GamePorts game) => new DepthLabeller(rays);
}
