using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Ports;

/// <summary>
/// What the harvest reads of a game's world. All calls come from the game's own thread. An entity that vanishes while it is read is left
/// out; any other exception passes through and ends the harvest with a message.
/// </summary>
public interface IWorld
{
    /// <summary>The game's frame count; it increases by one per tick, paused or not.</summary>
    long GameFrame { get; }

    /// <summary>The game's time, seconds; it stands still while the game is frozen.</summary>
    double TimeSeconds { get; }

    /// <summary>Reads the camera of the frame that is being rendered.</summary>
    CameraState ReadCamera();

    /// <summary>Reads the vehicle that carries the camera.</summary>
    EgoState ReadEgo();

    /// <summary>Reads the entities whose origins lie within a distance of a point, without the ego vehicle.</summary>
    /// <param name="centre">Metres, world.</param>
    /// <param name="range">Metres; greater than 0.</param>
    IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range);

    /// <summary>Reads the current weather and time of day.</summary>
    EnvironmentState ReadEnvironment();
}
