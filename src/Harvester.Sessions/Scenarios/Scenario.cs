namespace Harvester.Sessions.Scenarios;

/// <summary>A situation in traffic that is staged: actors, and what they do when. File format: docs/scenarios.md.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Kind">What happens, as a word in camel case.</param>
/// <param name="Actors">The actors, at least one.</param>
/// <param name="Events">What they do, in the order of the file.</param>
public sealed record Scenario(string Name, string Kind, IReadOnlyList<ScenarioActor> Actors, IReadOnlyList<ScenarioEvent> Events)
{
    /// <summary>What happens, in a sentence or two; may be empty.</summary>
    public string Description { get; init; } = "";

    /// <summary>The values drawn for the parameters, by name.</summary>
    public IReadOnlyDictionary<string, double> Values { get; init; } = new Dictionary<string, double>();

    /// <summary>What the ego does.</summary>
    public ScenarioEgo Ego { get; init; } = new();

    /// <summary>What the place must have.</summary>
    public ScenarioNeeds Place { get; init; } = new();

    /// <summary>When it is over.</summary>
    public ScenarioEnd End { get; init; } = new();
}
