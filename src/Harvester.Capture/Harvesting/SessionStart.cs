using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>What is known when a session begins.</summary>
/// <param name="Options">The options of the harvest.</param>
/// <param name="GameFrame">The game's count of frames.</param>
/// <param name="TimeSeconds">The game's time, seconds.</param>
/// <param name="Camera">The camera at that moment.</param>
public sealed record SessionStart(HarvestOptions Options, long GameFrame, double TimeSeconds, CameraState Camera)
{
    /// <summary>By how much the camera model was off against markers, pixels of the image; null when it was not checked.</summary>
    public double? CameraErrorPixels { get; init; }

    /// <summary>The ways of freezing that were tried; null when none was.</summary>
    public FreezeReport? Freezing { get; init; }
}
