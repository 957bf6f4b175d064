using Harvester.Geometry;

namespace Harvester.Sessions.Labels;

/// <summary>The car after one tick of a recorded drive.</summary>
/// <param name="TimeSeconds">The game's time, seconds.</param>
/// <param name="SpeedMetresPerSecond">Speed, m/s; 0 or more.</param>
/// <param name="Driver">Who drove in the tick.</param>
public sealed record DriveTick(double TimeSeconds, double SpeedMetresPerSecond, DriverKind Driver)
{
    /// <summary>The mean acceleration in the tick without gravity, m/s², along the car's right, forward and up; null if unknown.</summary>
    public Vector3D? Acceleration { get; init; }

    /// <summary>The mean turning rate in the tick, rad/s, about the car's right, forward and up; null if unknown.</summary>
    public Vector3D? AngularRate { get; init; }

    /// <summary>The controls that moved the car in the tick; null if unknown.</summary>
    public DriveControls? Applied { get; init; }
}
