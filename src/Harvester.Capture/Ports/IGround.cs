using Harvester.Geometry;
using Harvester.Geometry.Grids;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Ports;

/// <summary>The ground as a game or its road data know it.</summary>
public interface IGround
{
    /// <summary>Where it comes from.</summary>
    BirdsEyeSource Source { get; }

    /// <summary>The faces of the ground around a place, and possibly some farther away.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="range">Horizontal distance, metres.</param>
    /// <returns>Null if nothing is known there.</returns>
    IReadOnlyList<GroundFace>? Near(Vector3D place, double range);
}
