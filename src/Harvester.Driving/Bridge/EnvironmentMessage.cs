using System;

namespace Harvester.Driving.Bridge;

/// <summary>Sets weather, hour or both.</summary>
/// <param name="Weather">The game's name of the weather; null leaves it.</param>
/// <param name="TimeOfDay">Time since midnight; null leaves it.</param>
public sealed record EnvironmentMessage(string? Weather, TimeSpan? TimeOfDay) : ClientMessage;
