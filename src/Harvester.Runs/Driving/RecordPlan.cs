using Harvester.Capture.Harvesting;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Events;
using Harvester.Sessions.Imaging;

namespace Harvester.Runs.Driving;

/// <summary>How a drive is recorded.</summary>
/// <param name="Folder">Folder of the session, or of a numbered session for each drive.</param>
/// <param name="EverySeconds">Minimum game time between two frames, seconds.</param>
/// <param name="Size">Size of the images, pixels.</param>
public sealed record RecordPlan(string Folder, double EverySeconds, ImageSize Size)
{
    /// <summary>Whether the folder gets a numbered session for each drive.</summary>
    public bool IsNumbered { get; init; }

    /// <summary>File format of the images.</summary>
    public ImageFormat Format { get; init; } = ImageFormat.Png;

    /// <summary>How events are found; null to find none.</summary>
    public EventOptions? Events { get; init; }

    /// <summary>Space that stays free on the disk, bytes; 0 watches nothing.</summary>
    public long MinFreeBytes { get; init; } = HarvestOptions.DefaultMinFreeBytes;

    /// <summary>Settings of the drive for session.json, in their order.</summary>
    public IReadOnlyList<KeyValuePair<string, string>> Settings { get; init; } = [];
}
