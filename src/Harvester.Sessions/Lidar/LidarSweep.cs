namespace Harvester.Sessions.Lidar;

/// <summary>The points of one turn of a LiDAR, all of the same moment.</summary>
/// <param name="Sensor">Name of the LiDAR in the rig.</param>
/// <param name="Points">The points, by column and within a column by beam.</param>
/// <param name="RaysCast">Number of rays cast for them.</param>
public sealed record LidarSweep(string Sensor, IReadOnlyList<LidarPoint> Points, int RaysCast);
