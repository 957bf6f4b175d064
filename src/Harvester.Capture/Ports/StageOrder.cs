using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>A path for an actor and how to move along it. At its end the actor stops.</summary>
/// <param name="Path">At least two points on the ground, metres, world, each unlike the one before. The actor begins at the point nearest
/// to it.</param>
/// <param name="Speed">The speed to reach, m/s; 0 or more.</param>
/// <param name="Acceleration">How fast it is reached, m/s²; more than 0, also for braking.</param>
public sealed record StageOrder(IReadOnlyList<Vector3D> Path, double Speed, double Acceleration)
{
    /// <summary>Whether it moves backwards, looking against the path.</summary>
    public bool IsBackwards { get; init; }

    /// <summary>Whether it drives on at red lights and stop signs.</summary>
    public bool IgnoresLights { get; init; }

    /// <summary>Whether it drives on whatever stands in the way, until it touches it.</summary>
    public bool IgnoresOthers { get; init; }
}
