namespace Harvester.Play.Plans;

/// <summary>What ends an attempt at a trial.</summary>
public enum Mishap
{
    /// <summary>The player is dead.</summary>
    Dead,

    /// <summary>A cut scene has begun.</summary>
    CutScene,

    /// <summary>The game changes to another character.</summary>
    PlayerSwitch,

    /// <summary>The police look for the player.</summary>
    Wanted,

    /// <summary>The player is not in the vehicle.</summary>
    OnFoot,

    /// <summary>The vehicle is in water.</summary>
    InWater,

    /// <summary>The vehicle lies on its roof.</summary>
    UpsideDown,

    /// <summary>The vehicle has not moved for long.</summary>
    Stuck,

    /// <summary>The vehicle is far from the path that it should follow.</summary>
    OffPath,
}
