namespace Harvester.Geometry.Calibration;

/// <summary>A ball to be drawn in the world, and where it should be seen.</summary>
/// <param name="Centre">Its centre, metres, world.</param>
/// <param name="RadiusMetres">Its radius; the farther, the larger, so that all look alike in the picture.</param>
/// <param name="ExpectedPixel">Where the camera that planned it would see the centre.</param>
public readonly record struct PlannedMarker(Vector3D Centre, double RadiusMetres, Vector2D ExpectedPixel);
