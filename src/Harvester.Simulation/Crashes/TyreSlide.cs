using Harvester.Geometry;

namespace Harvester.Simulation.Crashes;

/// <summary>Friction of a body that slides on the ground on four locked wheels.</summary>
internal static class TyreSlide
{
    /// <summary>Where the wheels are, as shares of half the length and half the width: usual wheelbases and tracks of cars.</summary>
    private const double WheelbaseShare = 0.6;
    private const double TrackShare = 0.85;
    private const int Wheels = 4;

    /// <summary>Below these a body lies still, m/s and rad/s; friction alone would slow it down for ever shorter steps.</summary>
    private const double RestingSpeed = 0.01;
    private const double RestingYawRate = 0.01;

    /// <summary>Slows a body down; its kinetic energy never grows.</summary>
    /// <param name="body">The body.</param>
    /// <param name="deceleration">Friction coefficient times gravity, m/s².</param>
    /// <param name="seconds">Time step.</param>
    public static void Slow(PlanarBody body, double deceleration, double seconds)
    {
        Vector2D along = body.Forward * (body.HalfLength * WheelbaseShare);
        Vector2D across = body.Left * (body.HalfWidth * TrackShare);
        double most = body.Mass * deceleration * seconds / Wheels;
        (Vector2D frontLeft, double turnFrontLeft) = Friction(body, along + across, most);
        (Vector2D frontRight, double turnFrontRight) = Friction(body, along - across, most);
        (Vector2D rearLeft, double turnRearLeft) = Friction(body, across - along, most);
        (Vector2D rearRight, double turnRearRight) = Friction(body, (along + across) * -1, most);
        body.Velocity += (frontLeft + frontRight + (rearLeft + rearRight)) * (1 / body.Mass);
        body.YawRate += (turnFrontLeft + turnFrontRight + (turnRearLeft + turnRearRight)) / body.YawInertia;
        if (body.Velocity.Length < RestingSpeed && Math.Abs(body.YawRate) < RestingYawRate)
        {
            body.Velocity = default;
            body.YawRate = 0;
        }
    }

    private static (Vector2D Impulse, double Turn) Friction(PlanarBody body, Vector2D arm, double most)
    {
        Vector2D velocity = body.VelocityAt(body.Position + arm);
        double speed = velocity.Length;
        if (speed == 0)
        {
            return default;
        }

        // Coulomb: μ m g t / 4 against the velocity of the wheel, but no more than a quarter of what stops the wheel,
        // |v| / (1 / m + (r × u)² / I). The four together are then the mean of four states, none of which has more energy than before.
        Vector2D direction = velocity * (1 / speed);
        double lever = arm.Cross(direction);
        double stopping = speed / ((1 / body.Mass) + (lever * lever / body.YawInertia));
        double size = Math.Min(most, stopping / Wheels);
        return (direction * -size, -size * lever);
    }
}
