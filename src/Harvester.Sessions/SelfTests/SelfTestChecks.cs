namespace Harvester.Sessions.SelfTests;

/// <summary>The names of the checks, as in selftest.json.</summary>
public static class SelfTestChecks
{
    /// <summary>Whether grabbed pictures show the game's window.</summary>
    public const string Window = "window";

    /// <summary>Whether grabbed pictures show the whole window.</summary>
    public const string Scale = "scale";

    /// <summary>Whether bright colours are clipped, as by HDR.</summary>
    public const string Exposure = "exposure";

    /// <summary>Whether the colours between black and white are right.</summary>
    public const string Tones = "tones";

    /// <summary>Whether the game's pause stops the world.</summary>
    public const string FreezePaused = "freezePaused";

    /// <summary>Whether a time scale of 0 stops the world.</summary>
    public const string FreezeTimeScale = "freezeTimeScale";

    /// <summary>Whether the same entities exist while the game is paused.</summary>
    public const string EntitiesPaused = "entitiesPaused";

    /// <summary>Whether the same entities exist at a time scale of 0.</summary>
    public const string EntitiesTimeScale = "entitiesTimeScale";

    /// <summary>Whether weather and time of day stand still while the game is paused.</summary>
    public const string SkyPaused = "skyPaused";

    /// <summary>Whether weather and time of day stand still at a time scale of 0.</summary>
    public const string SkyTimeScale = "skyTimeScale";

    /// <summary>Whether the camera can be moved while the game is paused.</summary>
    public const string CameraPaused = "cameraPaused";

    /// <summary>Whether the camera can be moved at a time scale of 0.</summary>
    public const string CameraTimeScale = "cameraTimeScale";

    /// <summary>By how many ticks the picture lags behind the camera.</summary>
    public const string Lag = "lag";

    /// <summary>Whether the camera is reported in the tick that shows it.</summary>
    public const string CameraReport = "cameraReport";

    /// <summary>Whether the game's own display can be hidden while the world is frozen.</summary>
    public const string Hud = "hud";

    /// <summary>Whether something else is drawn over the picture.</summary>
    public const string Display = "display";

    /// <summary>Whether pictures of the frozen world differ in every pixel.</summary>
    public const string Noise = "noise";

    /// <summary>Whether parts of the picture of the frozen world keep changing.</summary>
    public const string Textures = "textures";

    /// <summary>Whether a part of the picture of the frozen world changes once.</summary>
    public const string LevelOfDetail = "levelOfDetail";

    /// <summary>Whether all calibration markers are drawn at once.</summary>
    public const string Markers = "markers";

    /// <summary>Whether the camera is a pinhole camera, or the lens is calibrated.</summary>
    public const string Lens = "lens";

    /// <summary>Whether objects can be hidden from pictures of the frozen world.</summary>
    public const string Hiding = "hiding";

    /// <summary>By how many ticks hiding is late.</summary>
    public const string HidingDelay = "hidingDelay";

    /// <summary>Whether rays meet the shapes that pictures show.</summary>
    public const string Rays = "rays";

    /// <summary>Whether the extents of models are those of the shapes that pictures show.</summary>
    public const string Dimensions = "dimensions";

    /// <summary>Whether rays report materials.</summary>
    public const string Materials = "materials";

    /// <summary>The cost of readings and rays.</summary>
    public const string Cost = "cost";

    /// <summary>All checks, in the order of the result.</summary>
    public static IReadOnlyList<string> All { get; } =
    [
        Window,
        Scale,
        Exposure,
        Tones,
        FreezePaused,
        EntitiesPaused,
        SkyPaused,
        CameraPaused,
        FreezeTimeScale,
        EntitiesTimeScale,
        SkyTimeScale,
        CameraTimeScale,
        Lag,
        CameraReport,
        Hud,
        Display,
        Noise,
        Textures,
        LevelOfDetail,
        Markers,
        Lens,
        Hiding,
        HidingDelay,
        Rays,
        Dimensions,
        Materials,
        Cost,
    ];
}
