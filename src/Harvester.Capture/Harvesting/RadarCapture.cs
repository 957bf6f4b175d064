using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>The detections of a rig's radars, which <see cref="RigFlow"/> measures once a moment.</summary>
internal sealed class RadarCapture() : CaptureChannel(FrameChannels.Radars)
{
    /// <inheritdoc />
    public override bool IsOn(HarvestOptions options) => options.Rig is { Radars.Count: > 0 };
}
