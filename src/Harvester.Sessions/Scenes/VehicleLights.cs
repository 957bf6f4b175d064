namespace Harvester.Sessions.Scenes;

/// <summary>Which lamps of a vehicle shine at one moment. Indicators blink, so one that is switched on is dark half of the time.</summary>
/// <param name="Brake">The brake lights.</param>
/// <param name="Left">The indicators on the left.</param>
/// <param name="Right">The indicators on the right.</param>
/// <param name="Head">Headlights and tail lamps.</param>
public readonly record struct VehicleLights(bool Brake, bool Left, bool Right, bool Head);
