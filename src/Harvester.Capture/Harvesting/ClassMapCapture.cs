using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>Class maps, from rays or as the simulation drew them.</summary>
internal sealed class ClassMapCapture() : CaptureChannel(FrameChannels.ClassMaps)
{
    /// <inheritdoc />
    public override bool IsOn(HarvestOptions options) => options.Semantics is not null;

    /// <inheritdoc />
    public override IChannelLabeller LabellerFor(LabellingOptions options, FrameRays rays, GamePorts game) =>
        new SemanticLabeller(options, rays, game.Paint, game.Surfaces);
}
