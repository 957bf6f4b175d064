namespace Harvester.Sessions.Scenes;

/// <summary>Weather and time of day of a scene.</summary>
/// <param name="Weather">The game's name of the weather in lower case: clear, extrasunny, clouds, rain, foggy and so on.</param>
/// <param name="TimeOfDay">Time since midnight in the game's world, less than a day.</param>
public sealed record EnvironmentState(string Weather, TimeSpan TimeOfDay);
