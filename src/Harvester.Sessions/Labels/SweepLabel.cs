namespace Harvester.Sessions.Labels;

/// <summary>What a LiDAR saw at the moment of a frame.</summary>
/// <param name="Sensor">Name of the LiDAR in the rig.</param>
/// <param name="File">Path of the points within the session, with forward slashes.</param>
/// <param name="Points">Number of points.</param>
/// <param name="RaysCast">Number of rays cast for them.</param>
public sealed record SweepLabel(string Sensor, string File, int Points, int RaysCast);
