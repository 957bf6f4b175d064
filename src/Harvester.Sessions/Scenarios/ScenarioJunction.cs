namespace Harvester.Sessions.Scenarios;

/// <summary>The junction that a scenario needs.</summary>
/// <param name="From">Least distance from the ego to its entry, metres.</param>
/// <param name="To">Greatest distance, metres.</param>
public sealed record ScenarioJunction(double From, double To)
{
    /// <summary>Whether it has traffic lights; null if that does not matter.</summary>
    public bool? Light { get; init; }

    /// <summary>The sides from which roads must come in.</summary>
    public IReadOnlyList<ScenarioApproach> Approaches { get; init; } = [];
}
