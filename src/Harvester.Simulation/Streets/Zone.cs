namespace Harvester.Simulation.Streets;

/// <summary>How densely a place is built up.</summary>
internal enum Zone
{
    /// <summary>Fields, trees and rocks; roads without pavements.</summary>
    Country,

    /// <summary>Houses with gardens, also a village.</summary>
    Suburb,

    /// <summary>Houses and blocks wall to wall.</summary>
    Town,

    /// <summary>Blocks and towers.</summary>
    Centre,
}
