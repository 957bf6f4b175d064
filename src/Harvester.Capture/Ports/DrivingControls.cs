using System;

namespace Harvester.Capture.Ports;

/// <summary>What a driver does with wheel and pedals. Values beyond their range are cut to it.</summary>
public readonly record struct DrivingControls
{
    /// <summary>Makes controls.</summary>
    /// <param name="steering">-1 is full lock to the right, 1 full lock to the left.</param>
    /// <param name="throttle">0 to 1.</param>
    /// <param name="brake">0 to 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is not a number.</exception>
    public DrivingControls(double steering, double throttle, double brake)
    {
        Steering = Cut(steering, -1, nameof(steering));
        Throttle = Cut(throttle, 0, nameof(throttle));
        Brake = Cut(brake, 0, nameof(brake));
    }

    /// <summary>Wheel straight, brake down: what a car does that nobody drives any more.</summary>
    public static DrivingControls Stop { get; } = new(0, 0, 1);

    /// <summary>-1 (right) to 1 (left).</summary>
    public double Steering { get; }

    /// <summary>0 to 1.</summary>
    public double Throttle { get; }

    /// <summary>0 to 1.</summary>
    public double Brake { get; }

    private static double Cut(double value, double least, string name) =>
        double.IsNaN(value)
            ? throw new ArgumentOutOfRangeException(name, value, $"{name} must be a number.")
            : Math.Max(least, Math.Min(1, value));
}
