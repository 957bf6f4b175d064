using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Ports;

/// <summary>A game as a harvest sees it. The mod and the simulation each provide one.</summary>
/// <param name="World">Camera, ego, entities, environment.</param>
/// <param name="Rays">Casts rays into the world.</param>
/// <param name="Screen">Grabs the displayed image.</param>
/// <param name="Pause">Freezes and resumes the world.</param>
/// <param name="Clock">Real time, independent of the game.</param>
/// <param name="Markers">Draws markers for calibration; null where the game cannot.</param>
public sealed record GamePorts(IWorld World, IRayCaster Rays, IScreen Screen, IPause Pause, IClock Clock, IMarkers? Markers = null)
{
    /// <summary>What is known of the roads; null for a harvest without lanes.</summary>
    public IRoads? Roads { get; init; }

    /// <summary>What is painted on the roads; null for a game that does not tell.</summary>
    public IRoadPaint? Paint { get; init; }

    /// <summary>The traffic lights that the harvester itself drives; null for none.</summary>
    public ILights? Lights { get; init; }

    /// <summary>The ego, to be driven from outside; null where it cannot be.</summary>
    public IDrivenCar? Car { get; init; }

    /// <summary>Counts what is asked of the game; null where nothing is counted.</summary>
    public ICallCounter? Calls { get; init; }

    /// <summary>What could not be read of the game as it should be; null for a game that is always read in full.</summary>
    public ReadingRecord? Reading { get; init; }

    /// <summary>The camera, to be moved on its vehicle; null where it cannot be.</summary>
    public IMountedCamera? MountedCamera { get; init; }
}
