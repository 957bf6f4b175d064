namespace Harvester.Sessions.Scenarios;

/// <summary>Something that a scenario did.</summary>
/// <param name="Event">Id of the event.</param>
/// <param name="HasEnded">Whether it ended then; otherwise it began.</param>
/// <param name="GameFrame">The game's frame count.</param>
/// <param name="Seconds">Seconds since the beginning of the scenario.</param>
public sealed record ScenarioLogEntry(string Event, bool HasEnded, long GameFrame, double Seconds);
