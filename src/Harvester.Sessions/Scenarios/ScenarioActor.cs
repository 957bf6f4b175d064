namespace Harvester.Sessions.Scenarios;

/// <summary>An actor of a scenario.</summary>
/// <param name="Id">Its name within the scenario.</param>
/// <param name="Type">What it is.</param>
/// <param name="Model">Name of the game's model, or of a class of models.</param>
/// <param name="Start">Where it begins.</param>
/// <param name="Speed">Its speed at the beginning, m/s; null for that of the ego.</param>
public sealed record ScenarioActor(string Id, ScenarioActorType Type, string Model, ScenarioStart Start, double? Speed)
{
    /// <summary>Whether it drives on whatever stands in its way, until it touches it.</summary>
    public bool IgnoresOthers { get; init; } = true;
}
