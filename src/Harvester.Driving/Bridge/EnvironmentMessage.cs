namespace Harvester.Driving.Bridge;

/// <summary>Sets the weather, the time of day or both.</summary>
/// <param name="Weather">The game's name of the weather; null leaves it unchanged.</param>
/// <param name="TimeOfDay">Time since midnight; null leaves it unchanged.</param>
public sealed record EnvironmentMessage(string? Weather, TimeSpan? TimeOfDay) : ClientMessage;
