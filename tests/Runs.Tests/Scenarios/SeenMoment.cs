namespace Harvester.Runs.Tests.Scenarios;

/// <summary>A tick of a scenario.</summary>
internal sealed record SeenMoment(double Seconds, SeenBody Ego, IReadOnlyDictionary<string, SeenBody> Actors);
