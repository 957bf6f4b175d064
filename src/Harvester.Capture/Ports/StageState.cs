using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>The state of an actor at one moment.</summary>
/// <param name="Pose">Its model's origin, metres, world, and its axes.</param>
/// <param name="Velocity">Metres per second, world.</param>
/// <param name="IsAtEnd">Whether it has come to the end of its path, or has none.</param>
/// <param name="HalfLength">Half of its length, metres.</param>
/// <param name="HalfWidth">Half of its width, metres.</param>
public sealed record StageState(Pose Pose, Vector3D Velocity, bool IsAtEnd, double HalfLength, double HalfWidth);
