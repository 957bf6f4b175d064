using Harvester.Capture.Faults;

namespace Harvester.Capture.Ports;

/// <summary>
/// The number of ticks by which the grabbed picture lags behind the state that is read in the same tick. Camera and entities are separate,
/// since the game reports the pose of an attached camera a frame late: the lag of the picture behind the camera is then one tick less.
/// </summary>
/// <param name="CameraTicks">Lag behind the reported camera; -1 if the picture shows a camera that is reported in the next tick.</param>
/// <param name="EntityTicks">Lag behind the entities; 0 or more.</param>
public readonly record struct PictureLag(int CameraTicks, int EntityTicks)
{
    /// <summary>Maximum lag that is measured and that a harvest may allow, ticks: a second at 60 frames per second.</summary>
    public const int MaxTicks = 60;

    /// <summary>The fault of a picture whose lag exceeds the limit.</summary>
    internal static CaptureFault Refusal(string lag, string what, int allowedTicks) =>
        new(FaultCode.PictureLate, FormattableString.Invariant($"The image is {lag} behind the game; the {what} allows {allowedTicks}."));
}
