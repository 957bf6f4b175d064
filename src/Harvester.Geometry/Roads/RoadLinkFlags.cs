namespace Harvester.Geometry.Roads;

/// <summary>The flags of a link in the game's path data. Names follow Figure 17 of the thesis.</summary>
[Flags]
public enum RoadLinkFlags
{
    /// <summary>No flag is set.</summary>
    None = 0,

    /// <summary>A road with narrow lanes.</summary>
    NarrowRoad = 1 << 0,

    /// <summary>Route guidance uses it both ways.</summary>
    GpsBothWays = 1 << 1,

    /// <summary>Blocked in a direction without lanes.</summary>
    BlockIfNoLanes = 1 << 2,

    /// <summary>A shortcut between carriageways that is not a painted road.</summary>
    Shortcut = 1 << 3,

    /// <summary>Not used for navigation.</summary>
    DontUseForNavigation = 1 << 4,
}
