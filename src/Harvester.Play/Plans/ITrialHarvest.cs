using Harvester.Capture.Harvesting;
using Harvester.Play.Features;

namespace Harvester.Play.Plans;

/// <summary>The harvest of a trial.</summary>
public interface ITrialHarvest
{
    /// <summary>Whether it is running.</summary>
    bool IsOn { get; }

    /// <summary>Whether files are still being opened or written.</summary>
    bool IsBusy { get; }

    /// <summary>Number of frames of the running harvest, or of the last one.</summary>
    int Captured { get; }

    /// <summary>Why the last harvest ended early; null if it ended normally, or none has ended.</summary>
    string? Fault { get; }

    /// <summary>Whether <see cref="Fault"/> is that the disk has too little space, which is no fault of a trial.</summary>
    bool IsSpaceLow { get; }

    /// <summary>Real time for a second of game time in the running harvest, or in the last one that measured it; null before.</summary>
    double? RealSecondsPerGameSecond { get; }

    /// <summary>Mounts the camera and begins a harvest in a new folder.</summary>
    /// <param name="folder">The folder of the session.</param>
    /// <param name="options">What to harvest and how.</param>
    /// <param name="verticalFovDegrees">Vertical field of view of the camera, degrees.</param>
    /// <param name="scenario">What the session keeps of the scenario of the trial; null without one.</param>
    /// <returns>Whether it began; otherwise the player has seen the reason.</returns>
    bool Begin(string folder, HarvestOptions options, double verticalFovDegrees, KeptScenario? scenario = null);

    /// <summary>Ends the harvest. Calling it again has no effect.</summary>
    void End();
}
