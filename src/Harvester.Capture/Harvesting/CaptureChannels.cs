using Harvester.Capture.Ports;

namespace Harvester.Capture.Harvesting;

/// <summary>All channels of harvests, in the order in which their labellers work in one turn.</summary>
internal static class CaptureChannels
{
    /// <summary>All channels.</summary>
    public static IReadOnlyList<CaptureChannel> All { get; } =
    [
        new ClassMapCapture(),
        new DepthCapture(),
        new NormalsCapture(),
        new FlowCapture(),
        new BirdsEyeCapture(),
        new OccupancyCapture(),
        new ImuCapture(),
        new GnssCapture(),
        new LidarCapture(),
        new RadarCapture(),
        new PairCapture(),
    ];

    /// <summary>The channels that a harvest has.</summary>
    public static IEnumerable<CaptureChannel> Of(HarvestOptions options) => All.Where(channel => channel.IsOn(options));

    /// <summary>Why a harvest cannot start, by the first channel that says so; null if it can.</summary>
    public static string? ProblemFor(HarvestOptions options, GamePorts game) =>
        Of(options).Select(channel => channel.ProblemFor(options, game)).OfType<string>().FirstOrDefault();
}
