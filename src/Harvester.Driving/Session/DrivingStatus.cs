using Harvester.Capture.Ports;

namespace Harvester.Driving.Session;

/// <summary>The state of a drive over a bridge.</summary>
/// <param name="Frames">Frames given to the bridge so far.</param>
/// <param name="IsClientAlive">Whether a client has sent controls recently; otherwise the car brakes.</param>
/// <param name="Controls">The last controls of the car.</param>
/// <param name="AreLanesKnown">Whether the lanes were known at the last frame; they are not in junctions and off the road.</param>
/// <param name="Ending">Why the drive is over, as a sentence; null while it continues.</param>
public readonly record struct DrivingStatus(long Frames, bool IsClientAlive, DrivingControls Controls, bool AreLanesKnown, string? Ending)
{
    /// <summary>Whether the drive is over. The car is not driven any more.</summary>
    public bool IsOver => Ending is not null;
}
