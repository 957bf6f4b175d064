using Harvester.Capture.Ports;

namespace Harvester.Capture.Harvesting;

/// <summary>How one freeze method affected the world when it was tried.</summary>
/// <param name="Method">The method.</param>
/// <param name="SawMovement">Whether camera or entities moved just before the freeze; if not, a world that stands still proves
/// little.</param>
/// <param name="SettleTicks">Game frames from the request until camera, ego vehicle and entities stood still; null if they never
/// did.</param>
public sealed record FreezeFinding(FreezeMethod Method, bool SawMovement, int? SettleTicks)
{
    /// <summary>Whether weather and time of day stood still too; null if the world did not.</summary>
    public bool? HoldsEnvironment { get; init; }

    /// <summary>
    /// Whether the camera could be moved on its mount in the frozen world, as reported and in the image; null if that was not tried.
    /// </summary>
    public bool? MovesCamera { get; init; }

    /// <summary>
    /// Maximum mean difference between successive images of the frozen world, 0 to 255 per channel, caused by rain, clouds or grain. Null
    /// if the world did not stand still or no image could be grabbed.
    /// </summary>
    public double? PictureChange { get; init; }

    /// <summary>Whether the world stood still.</summary>
    public bool HoldsWorld => SettleTicks is not null;

    /// <summary>The finding as text, for a log.</summary>
    public override string ToString()
    {
        string movement = SawMovement ? string.Empty : " (nothing was moving before)";
        string world = SettleTicks is { } ticks
            ? FormattableString.Invariant($"the world stood still after {ticks} ticks")
            : "the world never stood still";
        string environment = HoldsEnvironment == false ? ", weather or time of day changed" : string.Empty;
        string camera = MovesCamera switch
        {
            true => ", the camera could be moved",
            false => ", the camera could not be moved",
            null => string.Empty,
        };
        string picture = PictureChange is { } change
            ? FormattableString.Invariant($", the image changed by {change:0.00} of 255")
            : string.Empty;
        return $"{Method}: {world}{movement}{environment}{camera}{picture}";
    }
}
