namespace Harvester.Sessions.Labels;

/// <summary>Positions of steering wheel and pedals as they are recorded.</summary>
/// <param name="Steering">-1 is full lock to the right, 1 full lock to the left.</param>
/// <param name="Throttle">Throttle pedal, 0 (released) to 1 (fully pressed).</param>
/// <param name="Brake">Brake pedal, 0 (released) to 1 (fully pressed).</param>
public readonly record struct DriveControls(double Steering, double Throttle, double Brake);
