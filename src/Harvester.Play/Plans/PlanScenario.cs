using Harvester.Sessions.Scenarios;

namespace Harvester.Play.Plans;

/// <summary>The scenario of a plan's place.</summary>
/// <param name="Template">The scenario.</param>
/// <param name="Text">The text of its file.</param>
internal readonly record struct PlanScenario(ScenarioTemplate Template, string Text);
