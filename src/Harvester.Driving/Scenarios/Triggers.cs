using Harvester.Sessions.Scenarios;

namespace Harvester.Driving.Scenarios;

/// <summary>Whether the conditions of an event hold.</summary>
internal static class Triggers
{
    /// <summary>Whether an event may begin.</summary>
    /// <param name="each">The event.</param>
    /// <param name="view">What is seen in this tick.</param>
    /// <param name="actors">The actors by id.</param>
    /// <param name="phases">The phases of all events by id.</param>
    public static bool Hold(
        ScenarioEvent each,
        SceneView view,
        IReadOnlyDictionary<string, StagedActor> actors,
        IReadOnlyDictionary<string, EventPhase> phases
    ) =>
        each.When.Count == 0
        || (
            each.IsAny
                ? each.When.Any(condition => Holds(condition, view, actors, phases))
                : each.When.All(condition => Holds(condition, view, actors, phases))
        );

    private static bool Holds(
        ScenarioCondition condition,
        SceneView view,
        IReadOnlyDictionary<string, StagedActor> actors,
        IReadOnlyDictionary<string, EventPhase> phases
    ) =>
        condition.Kind switch
        {
            ScenarioConditionKind.Seconds => view.Seconds >= condition.Value,
            ScenarioConditionKind.Distance => view.DistanceTo(actors[condition.Actor!]) <= condition.Value,
            ScenarioConditionKind.TimeToCollision => view.TimeToCollision(actors[condition.Actor!]) <= condition.Value,
            ScenarioConditionKind.EgoArrival => view.SecondsFor(
                condition.Actor is { } actor ? view.AheadOf(actors[actor]) : view.ToJunction
            ) <= condition.Value,
            ScenarioConditionKind.EgoToJunction => view.ToJunction <= condition.Value,
            ScenarioConditionKind.EgoFaster => view.EgoSpeed >= condition.Value,
            ScenarioConditionKind.EgoSlower => view.EgoSpeed <= condition.Value,
            ScenarioConditionKind.ActorSlower => actors[condition.Actor!].Speed <= condition.Value,
            ScenarioConditionKind.Ahead => view.AheadOf(actors[condition.Actor!]) >= condition.Value,
            ScenarioConditionKind.Light => view.Light == condition.Light,
            ScenarioConditionKind.Begun => phases[condition.Event!] >= EventPhase.Running,
            _ => phases[condition.Event!] == EventPhase.Over,
        };
}
