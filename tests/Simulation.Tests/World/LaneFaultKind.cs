namespace Harvester.Simulation.Tests.World;

internal enum LaneFaultKind
{
    /// <summary>No ground is within reach below the lane.</summary>
    NoGround,

    /// <summary>The ground is not at the height of the lane.</summary>
    Uneven,

    /// <summary>Something hangs in the space above the lane that a lorry needs.</summary>
    Low,

    /// <summary>Something stands across the lane.</summary>
    Barred,
}
