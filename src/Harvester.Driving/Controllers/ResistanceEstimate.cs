namespace Harvester.Driving.Controllers;

/// <summary>
/// Estimates by how much a car accelerates less than its throttle should make it: by the slope, the air and the tyres, and because the car
/// is weaker than assumed. A controller that adds this to the acceleration that it wants can start on a steep road.
/// </summary>
internal sealed class ResistanceEstimate
{
    /// <summary>More than the steepest street takes: a slope of 45 % takes 4 m/s².</summary>
    private const double Largest = 4;

    /// <summary>
    /// Weight of a frame that shows more resistance. It is small because somebody else may have driven in this frame where the pedals in
    /// force are unknown, such as a driver who waits at a light.
    /// </summary>
    private const double Rise = 0.05;
    private const double Fall = 0.3;
    private double? _speed;
    private double _asked;

    /// <summary>The resistance, m/s²; 0 at first.</summary>
    public double Value { get; private set; }

    /// <summary>Adds a frame.</summary>
    /// <param name="speed">The car's speed, m/s.</param>
    /// <param name="seconds">Time since the previous frame, seconds.</param>
    /// <param name="inForce">What the pedals in force since then give without resistance, m/s²; null if unknown.</param>
    public void Observe(double speed, double seconds, double? inForce)
    {
        double asked = inForce ?? _asked;
        if (_speed is { } before && asked > 0)
        {
            // Resistance = acceleration asked for minus acceleration seen; the filter follows a fall faster than a rise.
            double missing = asked - ((speed - before) / seconds);
            Value = Math.Max(0, Math.Min(Largest, Value + ((missing > Value ? Rise : Fall) * (missing - Value))));
        }

        _speed = speed;
    }

    /// <summary>Remembers what the throttle is to give until the next frame.</summary>
    /// <param name="acceleration">Acceleration without resistance, m/s²; negative for the brake.</param>
    public void Ask(double acceleration) => _asked = acceleration;
}
