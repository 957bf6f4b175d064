using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Where a sensor was shortly before a moment: its vehicle is taken to have moved at constant speed and turned at a constant rate about the
/// vertical, so that it was on a circle, or on a straight line if the rate is 0 or unknown.
/// </summary>
/// <param name="ego">The vehicle at the moment.</param>
/// <param name="mount">The sensor's pose in the frame of the vehicle's model.</param>
internal sealed class SensorMotion(EgoState ego, Pose mount)
{
    /// <summary>A turn of less than this within the time is a straight line, radians.</summary>
    private const double MinTurn = 1e-9;

    private readonly double _yawRate = ego.Motion?.YawRate ?? 0;

    /// <summary>The sensor's pose in the world at a time near the moment.</summary>
    /// <param name="seconds">Time since the moment, seconds; negative before it.</param>
    public Pose At(double seconds)
    {
        double turn = _yawRate * seconds;
        (double sine, double cosine) = (Math.Sin(turn), Math.Cos(turn));
        Vector3D velocity = ego.Velocity;
        Vector3D way = velocity * seconds;
        if (Math.Abs(turn) > MinTurn)
        {
            // The integral of the turning velocity: sin(ωt) / ω along it, and (1 - cos(ωt)) / ω to its left.
            double ahead = sine / _yawRate;
            double left = (1 - cosine) / _yawRate;
            way = new Vector3D(
                (velocity.X * ahead) - (velocity.Y * left),
                (velocity.Y * ahead) + (velocity.X * left),
                velocity.Z * seconds
            );
        }

        Axes axes = ego.Pose.Axes;
        var vehicle = new Pose(ego.Pose.Position + way, Axes.FromVectors(Turned(axes.Right), Turned(axes.Forward), Turned(axes.Up)));
        return vehicle.Compose(mount);

        Vector3D Turned(Vector3D vector) => new((vector.X * cosine) - (vector.Y * sine), (vector.X * sine) + (vector.Y * cosine), vector.Z);
    }
}
