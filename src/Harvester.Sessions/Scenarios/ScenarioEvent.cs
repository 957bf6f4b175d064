namespace Harvester.Sessions.Scenarios;

/// <summary>Something that an actor does.</summary>
/// <param name="Id">Its name within the scenario.</param>
/// <param name="Actor">Id of the actor.</param>
/// <param name="Action">What it does.</param>
public sealed record ScenarioEvent(string Id, string Actor, ScenarioAction Action)
{
    /// <summary>What must hold for it to begin; empty to begin at once.</summary>
    public IReadOnlyList<ScenarioCondition> When { get; init; } = [];

    /// <summary>Whether one of the conditions is enough.</summary>
    public bool IsAny { get; init; }

    /// <summary>Seconds from then to its beginning.</summary>
    public double Delay { get; init; }
}
