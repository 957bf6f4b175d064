using System;
using Harvester.Capture.Faults;

namespace Harvester.Capture.Ports;

/// <summary>
/// By how many ticks the picture that a grab finds is behind the state that is read in the same tick. Camera and entities are kept
/// apart, since the game reports the pose of an attached camera a frame late: the picture is then one tick less behind the camera.
/// </summary>
/// <param name="CameraTicks">Behind the camera that is reported; -1 when the picture shows a camera that is reported in the next
/// tick.</param>
/// <param name="EntityTicks">Behind the entities; 0 or more.</param>
public readonly record struct PictureLag(int CameraTicks, int EntityTicks)
{
    /// <summary>
    /// The greatest lag of a picture that is looked for and that a harvest may allow, ticks: a second at 60 frames a second.
    /// </summary>
    public const int MaxTicks = 60;

    /// <summary>The fault of a picture that is later than the limit.</summary>
    internal static CaptureFault Refusal(string lag, string what, int allowedTicks) => new(
        FaultCode.PictureLate, FormattableString.Invariant($"The picture is {lag} behind the game; the {what} allows {allowedTicks}."));
}
