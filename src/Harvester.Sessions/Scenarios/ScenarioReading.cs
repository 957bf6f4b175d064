namespace Harvester.Sessions.Scenarios;

/// <summary>What was read from a scenario file.</summary>
/// <param name="Template">The scenario with its parameters; null if it has problems.</param>
/// <param name="Problems">A line for each problem, which names the field; empty for a scenario that can be staged.</param>
public sealed record ScenarioReading(ScenarioTemplate? Template, IReadOnlyList<string> Problems);
