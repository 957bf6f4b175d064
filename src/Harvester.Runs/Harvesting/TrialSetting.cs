namespace Harvester.Runs.Harvesting;

/// <summary>What a harvest has from the plan whose trial it is.</summary>
/// <param name="Plan">Name of the plan.</param>
/// <param name="Id">Id of the trial.</param>
/// <param name="TrafficSeed">Seed of traffic, people and routes; the streets have that of the harvest.</param>
/// <param name="Drive">Where and how far to drive; made for this harvest.</param>
public sealed record TrialSetting(string Plan, string Id, int TrafficSeed, TrialDrive Drive);
