using Harvester.Sessions.Scenarios;

namespace Harvester.Runs.Scenarios;

/// <summary>A scenario to stage in a harvest.</summary>
/// <param name="Template">The scenario file.</param>
/// <param name="Seed">The seed from which its parameters, and without a given place its place, are drawn.</param>
public sealed record PlannedScenario(ScenarioTemplate Template, int Seed)
{
    /// <summary>Whether the ego's driver takes no notice of the actors.</summary>
    public bool IsEgoBlind { get; init; }

    /// <summary>Direction of the ego at a given place, degrees counter-clockwise from north; null for that of the nearest lane.</summary>
    public double? HeadingDegrees { get; init; }
}
