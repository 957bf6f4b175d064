using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Play.Features;
using Harvester.Play.Settings;

namespace Harvester.Play.Setup;

/// <summary>What the features of a mod are made from, apart from the game.</summary>
public sealed record ModSetup
{
    /// <summary>The files beside the mod.</summary>
    public required ModFolder Folder { get; init; }

    /// <summary>The player's settings.</summary>
    public required PlayerSettings Player { get; init; }

    /// <summary>Messages to the player.</summary>
    public required PlayerMessages Messages { get; init; }

    /// <summary>Takes the pictures.</summary>
    public required IScreen Screen { get; init; }

    /// <summary>Real time, from a tape when one is played.</summary>
    public required IClock Clock { get; init; }

    /// <summary>Real time, by which the cost of features is logged.</summary>
    public required IClock RealTime { get; init; }

    /// <summary>The game's settings.xml; it need not exist.</summary>
    public required string GraphicsFile { get; init; }

    /// <summary>The origin of sessions, except for when they are recorded.</summary>
    public required SessionOrigin Origin { get; init; }
}
