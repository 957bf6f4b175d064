using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>The known roads. They may grow while the car drives, as when the game's own road data is read during the drive.</summary>
public interface IRoads
{
    /// <summary>The roads known around a position.</summary>
    /// <param name="position">Metres, world.</param>
    /// <returns>Null if none are known there.</returns>
    KnownRoads? Near(Vector3D position);
}
