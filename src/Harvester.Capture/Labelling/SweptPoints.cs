using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Lidar;

namespace Harvester.Capture.Labelling;

/// <summary>The points of the LiDARs at a moment; part of its first view.</summary>
/// <param name="sweeps">One sweep of each LiDAR, in the order of the rig.</param>
public sealed class SweptPoints(IReadOnlyList<LidarSweep> sweeps) : FramePart
{
    /// <summary>One sweep of each LiDAR, in the order of the rig.</summary>
    public IReadOnlyList<LidarSweep> Sweeps => sweeps;

    /// <inheritdoc />
    protected override IReadOnlyList<FileContent> Contents =>
        [.. sweeps.Select(static sweep => new FileContent((stream, _) => LidarFile.Write(stream, sweep.Points)))];

    /// <inheritdoc />
    public override IChannelLabel LabelIn(FrameKey key) =>
        new SweepsLabel([
            .. sweeps.Select(sweep => new SweepLabel(
                sweep.Sensor,
                FramePaths.Sweep(key.Frame, sweep.Sensor),
                sweep.Points.Count,
                sweep.RaysCast
            )),
        ]);
}
