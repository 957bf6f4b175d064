using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>The points of a rig's LiDARs, which <see cref="RigFlow"/> measures once a moment.</summary>
internal sealed class LidarCapture() : CaptureChannel(FrameChannels.Sweeps)
{
    /// <inheritdoc />
    public override bool IsOn(HarvestOptions options) => options.Rig is { Lidars.Count: > 0 };

    /// <inheritdoc />
    public override IEnumerable<string> FoldersFor(HarvestOptions options) =>
        With(FramePaths.Lidar, options.Rig!.Lidars.Select(static lidar => lidar.Name));
}
