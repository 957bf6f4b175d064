using System.Xml.Linq;
using Harvester.Sessions.Scenarios;

namespace Harvester.Runs.Scenarios;

/// <summary>Writes the conditions of events as OpenSCENARIO.</summary>
internal static class OpenScenarioConditions
{
    /// <summary>A condition of an event.</summary>
    /// <param name="condition">The condition.</param>
    /// <param name="name">Its name in the file.</param>
    /// <param name="each">The event.</param>
    public static XElement Of(ScenarioCondition condition, string name, ScenarioEvent each) =>
        condition.Kind switch
        {
            ScenarioConditionKind.Seconds => AtTime(name, condition.Value, each.Delay),
            ScenarioConditionKind.Begun or ScenarioConditionKind.Ended => Condition(
                name,
                each.Delay,
                new XElement(
                    "ByValueCondition",
                    new XElement(
                        "StoryboardElementStateCondition",
                        new XAttribute("storyboardElementType", "event"),
                        new XAttribute("storyboardElementRef", condition.Event!),
                        new XAttribute("state", condition.Kind == ScenarioConditionKind.Begun ? "runningState" : "completeState")
                    )
                )
            ),
            ScenarioConditionKind.Distance => OfEntity(
                name,
                each.Delay,
                OpenScenarioWriter.Ego,
                new XElement(
                    "RelativeDistanceCondition",
                    new XAttribute("entityRef", condition.Actor!),
                    new XAttribute("relativeDistanceType", "euclidianDistance"),
                    new XAttribute("freespace", "false"),
                    new XAttribute("rule", "lessOrEqual"),
                    OpenScenarioWriter.Number("value", condition.Value)
                )
            ),
            ScenarioConditionKind.TimeToCollision => OfEntity(
                name,
                each.Delay,
                OpenScenarioWriter.Ego,
                new XElement(
                    "TimeToCollisionCondition",
                    new XAttribute("freespace", "true"),
                    new XAttribute("rule", "lessOrEqual"),
                    OpenScenarioWriter.Number("value", condition.Value),
                    new XElement("TimeToCollisionConditionTarget", new XElement("EntityRef", new XAttribute("entityRef", condition.Actor!)))
                )
            ),
            _ => OfEntity(
                name,
                each.Delay,
                condition.Actor ?? OpenScenarioWriter.Ego,
                new XElement(
                    "SpeedCondition",
                    new XAttribute("rule", condition.Kind == ScenarioConditionKind.EgoFaster ? "greaterOrEqual" : "lessOrEqual"),
                    OpenScenarioWriter.Number("value", condition.Value)
                )
            ),
        };

    /// <summary>A condition that holds from a time on.</summary>
    public static XElement AtTime(string name, double seconds, double delay) =>
        Condition(
            name,
            delay,
            new XElement(
                "ByValueCondition",
                new XElement(
                    "SimulationTimeCondition",
                    new XAttribute("rule", "greaterOrEqual"),
                    OpenScenarioWriter.Number("value", seconds)
                )
            )
        );

    private static XElement OfEntity(string name, double delay, string entity, XElement condition) =>
        Condition(
            name,
            delay,
            new XElement(
                "ByEntityCondition",
                new XElement(
                    "TriggeringEntities",
                    new XAttribute("triggeringEntitiesRule", "any"),
                    new XElement("EntityRef", new XAttribute("entityRef", entity))
                ),
                new XElement("EntityCondition", condition)
            )
        );

    private static XElement Condition(string name, double delay, XElement content) =>
        new(
            "Condition",
            new XAttribute("name", name),
            OpenScenarioWriter.Number("delay", delay),
            new XAttribute("conditionEdge", "none"),
            content
        );
}
