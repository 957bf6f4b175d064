using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>What is recorded when a session begins.</summary>
/// <param name="Options">The options of the harvest.</param>
/// <param name="GameFrame">The game's frame count.</param>
/// <param name="TimeSeconds">The game's time, seconds.</param>
/// <param name="Camera">The camera at that moment.</param>
public sealed record SessionStart(HarvestOptions Options, long GameFrame, double TimeSeconds, CameraState Camera)
{
    /// <summary>Error of the camera model over markers, pixels of the image; null if it was not checked.</summary>
    public double? CameraErrorPixels { get; init; }

    /// <summary>The freeze methods that were tried; null if none was.</summary>
    public FreezeReport? Freezing { get; init; }

    /// <summary>Whether the game's display can be hidden while it is frozen; null if it was not checked.</summary>
    public DisplayFinding? Display { get; init; }

    /// <summary>How pictures show known colours; null if that was not checked.</summary>
    public ColourFinding? Colours { get; init; }
}
