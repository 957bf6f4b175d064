namespace Harvester.Sessions.Labels;

/// <summary>What a controller aims at when it answers a frame.</summary>
/// <param name="SpeedMetresPerSecond">The speed that it wants, m/s; 0 or more.</param>
/// <param name="RightMetres">
/// How far to the right of the car the line is that it steers to, metres; null if it has none or does not know it in metres.
/// </param>
public readonly record struct DriveTarget(double SpeedMetresPerSecond, double? RightMetres);
