using Harvester.Geometry;

namespace Harvester.Capture.Calibration;

/// <summary>A patch of an image that looks like a marker.</summary>
/// <param name="Centre">The centre of the area that it covers, continuous pixels.</param>
/// <param name="Area">Its area, square pixels.</param>
internal readonly record struct MarkerSpot(Vector2D Centre, double Area);
