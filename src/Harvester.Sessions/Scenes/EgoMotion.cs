namespace Harvester.Sessions.Scenes;

/// <summary>How the ego moves and what its driver does, where the game tells.</summary>
/// <param name="YawRate">Turning rate about the vertical, radians per second, positive to the left.</param>
/// <param name="Acceleration">Change of speed along the car, m/s², negative while it slows down.</param>
public sealed record EgoMotion(double YawRate, double Acceleration)
{
    /// <summary>Steering wheel, -1 (full lock right) to 1 (full lock left); null if the car is not moved by controls.</summary>
    public double? Steering { get; init; }

    /// <summary>Throttle pedal, 0 to 1; null if the car is not moved by controls.</summary>
    public double? Throttle { get; init; }

    /// <summary>Brake pedal, 0 to 1; null if the car is not moved by controls.</summary>
    public double? Brake { get; init; }

    /// <summary>What the driver is doing; null if another program drives or it is unknown.</summary>
    public Manoeuvre? Manoeuvre { get; init; }
}
