using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Play.Features;

namespace Harvester.Play.Plans;

/// <summary>What the trials of a plan use of the game and of the mod.</summary>
public sealed record TrialSurroundings
{
    /// <summary>The game, as far as trials need it.</summary>
    public required ITrialGame Game { get; init; }

    /// <summary>What is taken of the game.</summary>
    public required TrialGrip Grip { get; init; }

    /// <summary>Places vehicles, and sets the hour.</summary>
    public required ICarControls Controls { get; init; }

    /// <summary>The vehicle of the trials.</summary>
    public required TrialCar Car { get; init; }

    /// <summary>The vehicle with the camera, for drives along a path.</summary>
    public required IDrivenCar Driven { get; init; }

    /// <summary>The game's world.</summary>
    public required IWorld World { get; init; }

    /// <summary>The game's roads.</summary>
    public required IRoadSource Roads { get; init; }

    /// <summary>Tells when the picture has settled.</summary>
    public required PictureSettling Settling { get; init; }

    /// <summary>The actors of scenarios, and the roads on which they drive.</summary>
    public required TrialStage Stage { get; init; }

    /// <summary>The harvests.</summary>
    public required ITrialHarvest Harvest { get; init; }

    /// <summary>Real time.</summary>
    public required IClock Clock { get; init; }

    /// <summary>What to harvest and how, except for what the plan says.</summary>
    public required HarvestOptions Options { get; init; }

    /// <summary>Writes a line to the log.</summary>
    public required Action<string> Log { get; init; }
}
