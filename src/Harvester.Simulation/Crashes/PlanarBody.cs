using Harvester.Geometry;

namespace Harvester.Simulation.Crashes;

/// <summary>A rigid body on the ground: a rectangle whose centre of mass is its middle.</summary>
/// <param name="mass">Kilograms, greater than 0.</param>
/// <param name="yawInertia">
/// Moment of inertia about the vertical axis through the middle, kg m²; infinite for a body that never turns.
/// </param>
/// <param name="halfLength">Metres along its direction.</param>
/// <param name="halfWidth">Metres across it.</param>
internal sealed class PlanarBody(double mass, double yawInertia, double halfLength, double halfWidth)
{
    public double Mass { get; } = mass;

    public double YawInertia { get; } = yawInertia;

    public double HalfLength { get; } = halfLength;

    public double HalfWidth { get; } = halfWidth;

    /// <summary>Its middle, metres, world x and y.</summary>
    public Vector2D Position { get; set; }

    /// <summary>Direction of its length, radians counter-clockwise from east.</summary>
    public double Yaw { get; set; }

    /// <summary>Velocity of its middle, m/s.</summary>
    public Vector2D Velocity { get; set; }

    /// <summary>Radians per second, positive to the left.</summary>
    public double YawRate { get; set; }

    public bool IsAtRest => Velocity == default && YawRate == 0;

    public Vector2D Forward => new(Math.Cos(Yaw), Math.Sin(Yaw));

    public Vector2D Left => new(-Math.Sin(Yaw), Math.Cos(Yaw));

    /// <summary>Radius of the circle around it, metres.</summary>
    public double Radius => Math.Sqrt((HalfLength * HalfLength) + (HalfWidth * HalfWidth));

    /// <summary>m v² / 2 + I ω² / 2, joules.</summary>
    public double KineticEnergy => ((Mass * Velocity.Dot(Velocity)) + (YawRate == 0 ? 0 : YawInertia * YawRate * YawRate)) / 2;

    /// <summary>The corners, counter-clockwise from the front left one.</summary>
    public Vector2D[] Corners
    {
        get
        {
            Vector2D along = Forward * HalfLength;
            Vector2D across = Left * HalfWidth;
            return [Position + along + across, Position - along + across, Position - along - across, Position + along - across];
        }
    }

    /// <summary>Velocity of the point of the body at a place, m/s: v + ω × r.</summary>
    public Vector2D VelocityAt(Vector2D place)
    {
        Vector2D arm = place - Position;
        return Velocity + (new Vector2D(-arm.Y, arm.X) * YawRate);
    }

    /// <summary>Changes its motion by an impulse, N s, at a place.</summary>
    public void Push(Vector2D impulse, Vector2D place)
    {
        Velocity += impulse * (1 / Mass);
        YawRate += (place - Position).Cross(impulse) / YawInertia;
    }
}
