using Harvester.Geometry;

namespace Harvester.Play.Plans;

/// <summary>What can go wrong in the game during a trial, as it is at one moment.</summary>
public readonly record struct GameSituation
{
    /// <summary>Whether the player is dead.</summary>
    public bool IsDead { get; init; }

    /// <summary>Whether a cut scene is running.</summary>
    public bool IsInCutScene { get; init; }

    /// <summary>Whether the game changes to another character.</summary>
    public bool IsSwitching { get; init; }

    /// <summary>Number of the player's wanted stars.</summary>
    public int WantedLevel { get; init; }

    /// <summary>Whether the player sits in the vehicle of the trial.</summary>
    public bool IsInVehicle { get; init; }

    /// <summary>Whether that vehicle is in water.</summary>
    public bool IsInWater { get; init; }

    /// <summary>Whether that vehicle lies on its roof.</summary>
    public bool IsUpsideDown { get; init; }

    /// <summary>Where that vehicle is, metres, world.</summary>
    public Vector3D Position { get; init; }
}
