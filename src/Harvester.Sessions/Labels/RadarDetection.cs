namespace Harvester.Sessions.Labels;

/// <summary>A detection of a radar. File format: docs/radar.md.</summary>
/// <param name="Range">Distance from the sensor, metres; greater than 0.</param>
/// <param name="AzimuthDegrees">Angle to the left of the sensor's forward axis, degrees.</param>
/// <param name="ElevationDegrees">
/// Angle above the plane of the sensor, degrees; the truth, which a radar of this kind does not measure.
/// </param>
/// <param name="RadialVelocity">Change of the distance, m/s; positive while it grows.</param>
/// <param name="GroundVelocity">The part of it that is the target's own motion over the ground, m/s.</param>
/// <param name="CrossSection">Radar cross-section, decibels above 1 m².</param>
/// <param name="Object">The object's id; 0 for what has none.</param>
/// <param name="Origin">What it comes from.</param>
public readonly record struct RadarDetection(
    double Range,
    double AzimuthDegrees,
    double ElevationDegrees,
    double RadialVelocity,
    double GroundVelocity,
    double CrossSection,
    int Object,
    RadarOrigin Origin
);
