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

    /// <summary>Whether the game shows its head-up display and radar unless the harvest hides them.</summary>
    public bool ShowsHud { get; init; }

    /// <summary>Whether hiding the head-up display has no effect while the world is frozen.</summary>
    public bool HudStaysWhileFrozen { get; init; }

    /// <summary>Whether another program draws a display over the game, such as a frame-rate counter, which nothing hides.</summary>
    public bool ShowsForeignDisplay { get; init; }

    /// <summary>Factor of the grey levels of a grabbed picture, clipped at 255; greater than 1 as with HDR. Greater than 0.</summary>
    public double PictureGain { get; init; } = 1;

    /// <summary>Exponent of the grey levels of a grabbed picture, as fractions of 255; less than 1 washes it out. Greater than 0.</summary>
    public double PictureExponent { get; init; } = 1;

    /// <summary>Factor by which a grabbed picture is enlarged, so that it shows the window's upper left part only; at least 1.</summary>
    public double WindowScale { get; init; } = 1;

    /// <summary>Whether a grabbed picture shows another window.</summary>
    public bool ShowsOtherWindow { get; init; }

    /// <summary>Maximum number of balls that the game draws at a time; null for no limit.</summary>
    public int? MaxMarkers { get; init; }

    /// <summary>Width by which the reported extents of models exceed their shapes on each side, metres; 0 or more.</summary>
    public double ModelMarginMetres { get; init; }

    /// <summary>Whether rays report no materials.</summary>
    public bool HidesMaterials { get; init; }

    /// <summary>Number of ticks of a frozen world after which the level of detail of a part of the picture changes; 0 for never.</summary>
    public int DetailChangesAfterTicks { get; init; }
}
