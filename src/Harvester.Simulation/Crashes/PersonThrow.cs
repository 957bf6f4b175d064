namespace Harvester.Simulation.Crashes;

/// <summary>
/// The way of a person who is thrown: a flight, a landing with friction, and a slide to rest, as Searle and Searle, "The Trajectories of
/// Pedestrians, Motorcycles, Motorcyclists, etc., Following a Road Accident", SAE 831622 (1983). The person leaves horizontally, as in an
/// impact by the front of a vehicle.
/// </summary>
/// <param name="speed">Speed after the impact, m/s.</param>
/// <param name="drop">How far the middle of the body falls, metres.</param>
internal sealed class PersonThrow(double speed, double drop)
{
    /// <summary>Friction of clothes on asphalt, from the same paper.</summary>
    public const double Friction = 0.66;

    private const double Gravity = 9.81;

    /// <summary>t = √(2 h / g).</summary>
    public double FlightSeconds { get; } = Math.Sqrt(2 * drop / Gravity);

    /// <summary>The landing stops the fall at v = g t, and its friction takes μ v off the horizontal speed.</summary>
    private double SlidingSpeed => Math.Max(0, speed - (Friction * Gravity * FlightSeconds));

    private double SlideSeconds => SlidingSpeed / (Friction * Gravity);

    public double TotalSeconds => FlightSeconds + SlideSeconds;

    /// <summary>Horizontal way after a time, metres.</summary>
    public double MetresAt(double seconds)
    {
        double sliding = Math.Clamp(seconds - FlightSeconds, 0, SlideSeconds);
        return (speed * Math.Min(seconds, FlightSeconds)) + (SlidingSpeed * sliding) - (Friction * Gravity * sliding * sliding / 2);
    }

    /// <summary>Horizontal speed after a time, m/s.</summary>
    public double SpeedAt(double seconds) =>
        seconds < FlightSeconds ? speed : SlidingSpeed - (Friction * Gravity * Math.Clamp(seconds - FlightSeconds, 0, SlideSeconds));

    /// <summary>How far the middle of the body has fallen after a time, metres.</summary>
    public double FallenAt(double seconds) => Math.Min(drop, Gravity * seconds * seconds / 2);
}
