using Harvester.Geometry;

namespace Harvester.Sessions.Labels;

/// <summary>What the inertial unit of the vehicle measured from one tick of the game to the next. File format: docs/imu.md.</summary>
/// <param name="TimeSeconds">The game's time at the end of the interval, seconds.</param>
/// <param name="AngularRate">Mean angular rate about the body's axes right, forward and up, rad/s, right-handed.</param>
/// <param name="SpecificForce">Mean specific force along the body's axes right, forward and up, m/s².</param>
public readonly record struct ImuSample(double TimeSeconds, Vector3D AngularRate, Vector3D SpecificForce);
