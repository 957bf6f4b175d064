namespace Harvester.Sessions.Plans;

/// <summary>What was read from a plan file.</summary>
/// <param name="Plan">The plan; null if it has problems.</param>
/// <param name="Problems">A line for each problem, which names the field; empty for a plan that can run.</param>
public sealed record PlanReading(Plan? Plan, IReadOnlyList<string> Problems);
