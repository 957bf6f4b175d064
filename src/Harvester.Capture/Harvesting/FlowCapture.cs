using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>Dense motion between consecutive frames of a view; from rays it needs masks, which tell the objects apart.</summary>
internal sealed class FlowCapture() : CaptureChannel(FrameChannels.Flow)
{
    /// <inheritdoc />
    public override bool NeedsFrameBefore => true;

    /// <inheritdoc />
    public override bool NeedsNormals(GamePorts game) => game.Surfaces is null;

    /// <inheritdoc />
    public override string? ProblemFor(HarvestOptions options, GamePorts game) =>
        !options.Freeze || (game.Surfaces is null && game.SurfaceRays is null)
            ? "Flow needs a game that is frozen for each frame and reports normals."
        : game.Surfaces is null && !options.Masks ? "Flow from rays needs masks, which tell the objects apart. Switch masks on."
        : null;

    /// <inheritdoc />
    public override IChannelLabeller LabellerFor(LabellingOptions options, FrameRays rays, GamePorts game) =>
        new FlowLabeller(rays, game.Surfaces);
}
