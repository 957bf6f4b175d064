using System.Xml.Linq;
using Harvester.Sessions.Scenarios;

namespace Harvester.Runs.Scenarios;

/// <summary>Reads the conditions that <see cref="OpenScenarioConditions"/> writes.</summary>
internal static class OpenScenarioTriggers
{
    /// <summary>A condition of an event.</summary>
    public static ScenarioCondition Of(XElement condition)
    {
        XElement kind = condition.Only();
        if (kind.Name == "ByValueCondition")
        {
            return OfValue(kind.Only());
        }

        if (kind.Name != "ByEntityCondition")
        {
            throw OpenScenarioXml.Unsupported(kind);
        }

        string entity = kind.The("TriggeringEntities").Only().Text("entityRef");
        XElement inner = kind.The("EntityCondition").Only();
        bool isEgo = entity == OpenScenarioWriter.Ego;
        return (inner.Name.LocalName, IsUpper(inner)) switch
        {
            ("RelativeDistanceCondition", false) when isEgo => new ScenarioCondition(ScenarioConditionKind.Distance, inner.Number("value"))
            {
                Actor = inner.Text("entityRef"),
            },
            ("TimeToCollisionCondition", false) when isEgo => new ScenarioCondition(
                ScenarioConditionKind.TimeToCollision,
                inner.Number("value")
            )
            {
                Actor = inner.The("TimeToCollisionConditionTarget").The("EntityRef").Text("entityRef"),
            },
            ("SpeedCondition", var isUpper) when isEgo => new ScenarioCondition(
                isUpper ? ScenarioConditionKind.EgoFaster : ScenarioConditionKind.EgoSlower,
                inner.Number("value")
            ),
            ("SpeedCondition", false) => new ScenarioCondition(ScenarioConditionKind.ActorSlower, inner.Number("value")) { Actor = entity },
            _ => throw OpenScenarioXml.Unsupported(inner),
        };
    }

    private static ScenarioCondition OfValue(XElement value) =>
        value.Name.LocalName switch
        {
            "SimulationTimeCondition" when IsUpper(value) => new ScenarioCondition(ScenarioConditionKind.Seconds, value.Number("value")),
            "StoryboardElementStateCondition" when value.Text("storyboardElementType") == "event" => new ScenarioCondition(
                value.Text("state") switch
                {
                    "runningState" => ScenarioConditionKind.Begun,
                    "completeState" => ScenarioConditionKind.Ended,
                    var state => throw OpenScenarioXml.Wrong(value, $"the state {state} is not supported."),
                },
                0
            )
            {
                Event = value.Text("storyboardElementRef"),
            },
            _ => throw OpenScenarioXml.Unsupported(value),
        };

    /// <summary>Whether a condition holds above its value; otherwise below it.</summary>
    private static bool IsUpper(XElement condition) =>
        condition.Text("rule") switch
        {
            "greaterOrEqual" or "greaterThan" => true,
            "lessOrEqual" or "lessThan" => false,
            var rule => throw OpenScenarioXml.Wrong(condition, $"the rule {rule} is not supported."),
        };
}
