using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Labels;

/// <summary>The ego at one tick of the game between two frames.</summary>
/// <param name="TimeSeconds">The game's time, seconds.</param>
/// <param name="Position">The model's origin, metres, world.</param>
/// <param name="Right">The body's direction to the right in the world, as written or read.</param>
/// <param name="Forward">The body's direction forward in the world, as written or read.</param>
/// <param name="Velocity">Metres per second, world.</param>
/// <param name="Motion">How it moves and its controls; null if unknown. The manoeuvre is not recorded.</param>
public sealed record MotionSample(
    double TimeSeconds,
    Vector3D Position,
    Vector3D Right,
    Vector3D Forward,
    Vector3D Velocity,
    EgoMotion? Motion
)
{
    /// <summary>Position and orientation of the body.</summary>
    /// <exception cref="ArgumentException">The directions are no unit vectors at right angles.</exception>
    public Pose Pose => new(Position, Axes.FromVectors(Right, Forward, Right.Cross(Forward)));

    /// <summary>The sample of a vehicle.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="ego"/> is null.</exception>
    public static MotionSample Of(double timeSeconds, EgoState ego) =>
        ego is null
            ? throw new ArgumentNullException(nameof(ego))
            : new MotionSample(timeSeconds, ego.Pose.Position, ego.Pose.Axes.Right, ego.Pose.Axes.Forward, ego.Velocity, ego.Motion);
}
