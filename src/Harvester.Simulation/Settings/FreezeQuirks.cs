namespace Harvester.Simulation.Settings;

/// <summary>The faults of one freeze method of the simulated game; none by default.</summary>
public sealed record FreezeQuirks
{
    /// <summary>
    /// Maximum number of ticks for which the world creeps on before it stands still; the number differs from freeze to freeze.
    /// </summary>
    public int CreepTicks { get; init; }

    /// <summary>Whether the world creeps on for as long as it is frozen.</summary>
    public bool NeverStands { get; init; }

    /// <summary>
    /// Whether the camera can be moved on its mount only while the game runs; a change in a frozen game takes effect when it resumes.
    /// </summary>
    public bool HoldsCamera { get; init; }

    /// <summary>Whether rain and time of day continue.</summary>
    public bool LetsWeatherGoOn { get; init; }

    /// <summary>Whether vehicles appear and disappear, like those that the game streams in and out.</summary>
    public bool ChangesVisibility { get; init; }
}
