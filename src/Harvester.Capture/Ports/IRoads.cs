using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>What is known of the roads. It may grow while the car drives, as when the game's own road data is read on the way.</summary>
public interface IRoads
{
    /// <summary>The roads known around a place.</summary>
    /// <param name="position">Metres, world.</param>
    /// <returns>Null when none are known there.</returns>
    KnownRoads? Near(Vector3D position);
}
