using System.Collections.Generic;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Ports;

/// <summary>
/// What the harvest reads of a game's world. All calls come from the game's own thread. An entity that vanishes while it is read
/// is left out; any other failure is thrown as it is, and the session turns the harvest off with a message.
/// </summary>
public interface IWorld
{
    /// <summary>The game's count of frames; it grows by one a tick, paused or not.</summary>
    long GameFrame { get; }

    /// <summary>The game's time, seconds; it stands still while the game is frozen.</summary>
    double TimeSeconds { get; }

    /// <summary>The camera of the picture that is rendered now.</summary>
    CameraState ReadCamera();

    /// <summary>The vehicle that carries the camera.</summary>
    EgoState ReadEgo();

    /// <summary>The entities whose origins lie within a distance of a point, without the ego vehicle.</summary>
    /// <param name="centre">Metres, world.</param>
    /// <param name="range">Metres; greater than 0.</param>
    IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range);

    /// <summary>Reads the current weather and time of day.</summary>
    EnvironmentState ReadEnvironment();
}
