namespace Harvester.Sessions.Labels;

/// <summary>What a radar detected at a moment.</summary>
/// <param name="Sensor">Name of the radar in the rig.</param>
/// <param name="RaysCast">Number of rays cast for it.</param>
/// <param name="Detections">The detections, by range.</param>
public sealed record RadarScan(string Sensor, int RaysCast, IReadOnlyList<RadarDetection> Detections);
