using Harvester.Geometry;

namespace Harvester.Capture.Events;

/// <summary>A footprint that goes on with its present speed and turning rate.</summary>
/// <param name="Box">The footprint now.</param>
/// <param name="Origin">The point that has the velocity and about which the body turns: the model's origin, metres, world.</param>
/// <param name="Velocity">Horizontal velocity, m/s, world.</param>
/// <param name="YawRate">Turning rate of body and velocity, rad/s, positive to the left.</param>
internal readonly record struct GroundMotion(BodyBox Box, Vector2D Origin, Vector2D Velocity, double YawRate)
{
    /// <summary>Turns by less than this count as straight, radians: the displacement differs by less than a micrometre.</summary>
    private const double Straight = 1e-7;

    /// <summary>Distances below this count as contact, metres.</summary>
    private const double Contact = 0.001;

    /// <summary>Minimum step of time, seconds: the error of a time to collision.</summary>
    private const double MinStep = 0.001;

    /// <summary>Distance of the footprint's farthest corner from the origin, metres.</summary>
    private double Reach => (Box.Centre - Origin).Length + Box.Radius;

    /// <summary>The footprint after a time.</summary>
    /// <param name="seconds">Seconds, 0 or more.</param>
    public BodyBox After(double seconds)
    {
        double turn = YawRate * seconds;

        // Constant turning rate and speed: the displacement is the integral of the turning velocity.
        Vector2D moved =
            Math.Abs(turn) < Straight
                ? Velocity * seconds
                : (Velocity * (Math.Sin(turn) / YawRate)) + (Left(Velocity) * ((1 - Math.Cos(turn)) / YawRate));
        return Box with { Centre = Origin + moved + Turned(Box.Centre - Origin, turn), Forward = Turned(Box.Forward, turn) };
    }

    /// <summary>
    /// Time until two footprints touch, if both go on as they are; null if they do not within a time. A step of time is as long as they
    /// need for the distance between them at least (conservative advancement, Mirtich 1996).
    /// </summary>
    /// <param name="other">The other body.</param>
    /// <param name="horizonSeconds">Seconds that are looked ahead.</param>
    public double? TimeToCollision(GroundMotion other, double horizonSeconds)
    {
        double turning = (Math.Abs(YawRate) * Reach) + (Math.Abs(other.YawRate) * other.Reach);
        double bending = (Math.Abs(YawRate) * Velocity.Length) + (Math.Abs(other.YawRate) * other.Velocity.Length);
        for (double time = 0; time <= horizonSeconds; )
        {
            double gap = After(time).Gap(other.After(time));
            if (gap <= Contact)
            {
                return time;
            }

            // In a step h, the distance shrinks by at most h (relative speed + turning) + h² bending.
            double speed = (VelocityAfter(time) - other.VelocityAfter(time)).Length + turning;
            double step =
                bending > 0 ? (Math.Sqrt((speed * speed) + (4 * bending * gap)) - speed) / (2 * bending)
                : speed > 0 ? gap / speed
                : double.PositiveInfinity;
            time += Math.Max(step, MinStep);
        }

        return null;
    }

    private static Vector2D Left(Vector2D vector) => new(-vector.Y, vector.X);

    private static Vector2D Turned(Vector2D vector, double angle) => (vector * Math.Cos(angle)) + (Left(vector) * Math.Sin(angle));

    private Vector2D VelocityAfter(double seconds) => Turned(Velocity, YawRate * seconds);
}
