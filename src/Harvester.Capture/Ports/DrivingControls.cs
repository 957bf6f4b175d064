namespace Harvester.Capture.Ports;

/// <summary>Positions of steering wheel and pedals. Values out of range are clamped.</summary>
public readonly record struct DrivingControls
{
    /// <summary>Creates controls, clamping each value to its range.</summary>
    /// <param name="steering">-1 is full lock to the right, 1 full lock to the left.</param>
    /// <param name="throttle">Throttle pedal, 0 (released) to 1 (fully pressed).</param>
    /// <param name="brake">Brake pedal, 0 (released) to 1 (fully pressed).</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is NaN.</exception>
    public DrivingControls(double steering, double throttle, double brake)
    {
        Steering = Cut(steering, -1, nameof(steering));
        Throttle = Cut(throttle, 0, nameof(throttle));
        Brake = Cut(brake, 0, nameof(brake));
    }

    /// <summary>Wheel straight, full brake: the controls of a car without a driver.</summary>
    public static DrivingControls Stop { get; } = new(0, 0, 1);

    /// <summary>Steering wheel, -1 (full lock right) to 1 (full lock left).</summary>
    public double Steering { get; }

    /// <summary>Throttle pedal, 0 (released) to 1 (fully pressed).</summary>
    public double Throttle { get; }

    /// <summary>Brake pedal, 0 (released) to 1 (fully pressed).</summary>
    public double Brake { get; }

    private static double Cut(double value, double minimum, string name) =>
        double.IsNaN(value)
            ? throw new ArgumentOutOfRangeException(name, value, $"{name} must be a number.")
            : Math.Max(minimum, Math.Min(1, value));
}
