namespace Harvester.Simulation.Settings;

/// <summary>
/// Faults of the real game that the simulated game imitates; none by default. A window with another aspect ratio than the image and a lens
/// other than a pinhole are options of their own: <see cref="SimulationOptions.WindowAspect"/>, <see cref="SimulationOptions.Lens"/>.
/// </summary>
public sealed record GameQuirks
{
    /// <summary>Number of ticks by which the picture lags behind the state; 0 or more.</summary>
    public int PictureLagTicks { get; init; }

    /// <summary>Whether the camera is reported a tick late.</summary>
    public bool IsCameraReportedLate { get; init; }

    /// <summary>The faults of the game's pause.</summary>
    public FreezeQuirks Paused { get; init; } = new();

    /// <summary>The faults of a time scale of 0.</summary>
    public FreezeQuirks TimeScale { get; init; } = new();

    /// <summary>
    /// Fraction of the readings of entities after which one of those read vanishes, 0 to 1. It comes back within a second.
    /// </summary>
    public double VanishingFraction { get; init; }

    /// <summary>Whether rays hit the box around each entity instead of its shape.</summary>
    public bool RaysMeetBoxes { get; init; }

    /// <summary>
    /// Fraction of the moving vehicles beyond 30 m that rays pass through, 0 to 1; which ones changes with every state of the world.
    /// </summary>
    public double RayMissFraction { get; init; }

    /// <summary>Number of ticks after which the hiding or showing of an entity takes effect; 0, the next picture, or more.</summary>
    public int VisibilityDelayTicks { get; init; }

    /// <summary>Number of ticks in which a new weather or time of day fades in; 0, at once, or more.</summary>
    public int SlowSkyTicks { get; init; }

    /// <summary>Fraction of the entities that cannot be hidden, 0 to 1.</summary>
    public double UnhideableFraction { get; init; }

    /// <summary>Whether the shadows of hidden entities remain.</summary>
    public bool ShadowsRemain { get; init; }

    /// <summary>Standard deviation of the noise in every pixel of a picture, grey levels of 255; 0 or more.</summary>
    public double PictureNoiseLevels { get; init; }

    /// <summary>Whether textures move on in a tenth of the world while it is frozen, by 10 grey levels.</summary>
    public bool TexturesMove { get; init; }
}
