namespace Harvester.Simulation.Settings;

/// <summary>
/// In what the simulated game misbehaves as the real one does; by default in nothing. A window whose aspect is not the image's
/// and a lens that is no pinhole are options of their own: <see cref="SimulationOptions.WindowAspect"/>,
/// <see cref="SimulationOptions.Lens"/>.
/// </summary>
public sealed record GameQuirks
{
    /// <summary>By how many ticks the picture shown is behind the state; 0 or more.</summary>
    public int PictureLagTicks { get; init; }

    /// <summary>Whether the camera is reported as it was a tick ago.</summary>
    public bool IsCameraReportedLate { get; init; }

    /// <summary>In what the game's pause falls short.</summary>
    public FreezeQuirks Paused { get; init; } = new();

    /// <summary>In what a time scale of 0 falls short.</summary>
    public FreezeQuirks TimeScale { get; init; } = new();

    /// <summary>
    /// How often, of all readings of the entities, one of those read is gone right after it, 0 to 1. It comes back within a second.
    /// </summary>
    public double VanishingFraction { get; init; }

    /// <summary>Whether rays meet the box around each entity in place of its shape.</summary>
    public bool RaysMeetBoxes { get; init; }

    /// <summary>
    /// How many of the moving vehicles beyond 30 m rays pass through, 0 to 1; which ones changes with every state of the world.
    /// </summary>
    public double RayMissFraction { get; init; }
}
