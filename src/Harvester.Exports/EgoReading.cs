using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports;

/// <summary>The ego vehicle at one moment, as inertial sensors would report it.</summary>
/// <param name="TimeSeconds">Game time, seconds.</param>
/// <param name="Pose">Position of the model's origin, metres, world, and orientation.</param>
/// <param name="Velocity">Metres per second; forward, left, up.</param>
/// <param name="Acceleration">Metres per second squared, without gravity; forward, left, up.</param>
/// <param name="RotationRate">Radians per second about the axes forward, left and up.</param>
/// <param name="Controls">Steering, throttle and brake; null if unknown.</param>
internal sealed record EgoReading(
    double TimeSeconds,
    Pose Pose,
    Vector3D Velocity,
    Vector3D Acceleration,
    Vector3D RotationRate,
    EgoMotion? Controls
);
