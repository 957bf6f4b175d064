namespace Harvester.Simulation.Settings;

/// <summary>In what one way of freezing the simulated game falls short; by default in nothing.</summary>
public sealed record FreezeQuirks
{
    /// <summary>The most ticks that the world creeps on before it stands; how many they are differs from freeze to freeze.</summary>
    public int CreepTicks { get; init; }

    /// <summary>Whether the world creeps on for as long as it is frozen.</summary>
    public bool NeverStands { get; init; }

    /// <summary>
    /// Whether the camera can be moved on its mount only while the game runs; a change asked of a frozen game takes effect after it.
    /// </summary>
    public bool HoldsCamera { get; init; }

    /// <summary>Whether rain and the hour go on.</summary>
    public bool LetsWeatherGoOn { get; init; }

    /// <summary>Whether vehicles come and go, as those do that the game streams in and out.</summary>
    public bool ChangesVisibility { get; init; }
}
