using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Ports;

/// <summary>A game as a harvest sees it. The mod and the simulation each provide one.</summary>
/// <param name="World">Camera, ego, entities, environment.</param>
/// <param name="Rays">Casts rays into the world.</param>
/// <param name="Screen">Grabs the displayed image.</param>
/// <param name="Pause">Freezes and resumes the world.</param>
/// <param name="Clock">Real time, independent of the game.</param>
/// <param name="Markers">Draws markers for calibration; null if the game cannot.</param>
public sealed record GamePorts(IWorld World, IRayCaster Rays, IScreen Screen, IPause Pause, IClock Clock, IMarkers? Markers = null)
{
    /// <summary>The known roads; null for a harvest without lanes.</summary>
    public IRoads? Roads { get; init; }

    /// <summary>The paint on the roads; null if the game does not report it.</summary>
    public IRoadPaint? Paint { get; init; }

    /// <summary>What the picture truly shows, of a simulated game; otherwise null.</summary>
    public ISurfaceTruth? Surfaces { get; init; }

    /// <summary>The ground itself, of a simulated game; otherwise null.</summary>
    public IGround? Ground { get; init; }

    /// <summary>The surfaces of everything around the vehicle, of a simulated game; otherwise null.</summary>
    public ISolids? Solids { get; init; }

    /// <summary>The traffic lights that the harvester itself drives; null if there are none.</summary>
    public ILights? Lights { get; init; }

    /// <summary>How much of an entity the drawing hides; null if the game cannot tell, or is not to.</summary>
    public IDrawnOcclusion? DrawnOcclusion { get; init; }

    /// <summary>The ego as a car driven by a client or controller; null if it cannot be.</summary>
    public IDrivenCar? Car { get; init; }

    /// <summary>Counts the calls to the game; null if they are not counted.</summary>
    public ICallCounter? Calls { get; init; }

    /// <summary>What could not be read of the game correctly; null for a game that is always read completely.</summary>
    public ReadingRecord? Reading { get; init; }

    /// <summary>Hides entities from pictures; null if the game cannot.</summary>
    public IVisibility? Visibility { get; init; }

    /// <summary>Draws sheets in the world; null if the game cannot.</summary>
    public ISheets? Sheets { get; init; }

    /// <summary>Weather and time of day, if they can be set; otherwise null.</summary>
    public ISky? Sky { get; init; }

    /// <summary>The camera, if it can be moved on its vehicle; otherwise null.</summary>
    public IMountedCamera? MountedCamera { get; init; }

    /// <summary>The camera, if it can take the places of a rig's cameras; otherwise null.</summary>
    public IRigCamera? RigCamera { get; init; }

    /// <summary>Rays that report the normal of the surface; null if the game reports none.</summary>
    public ISurfaceRays? SurfaceRays { get; init; }

    /// <summary>The game's own display, which can be hidden; null if there is none.</summary>
    public IHud? Hud { get; init; }

    /// <summary>Draws known colours over the picture; null if the game cannot.</summary>
    public IColourCard? Card { get; init; }

    /// <summary>Puts actors into the world; null if the game cannot.</summary>
    public IStage? Stage { get; init; }
}
