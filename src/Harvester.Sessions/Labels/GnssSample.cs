using Harvester.Geometry;

namespace Harvester.Sessions.Labels;

/// <summary>What a satellite receiver in the vehicle reported at a moment. File format: docs/gnss.md.</summary>
/// <param name="TimeSeconds">The game's time, seconds.</param>
/// <param name="LatitudeDegrees">Latitude on WGS 84, degrees north.</param>
/// <param name="LongitudeDegrees">Longitude, degrees east.</param>
/// <param name="Altitude">Height above the ellipsoid, metres.</param>
/// <param name="Velocity">Velocity to the east, to the north and up, m/s.</param>
public readonly record struct GnssSample(
    double TimeSeconds,
    double LatitudeDegrees,
    double LongitudeDegrees,
    double Altitude,
    Vector3D Velocity
);
