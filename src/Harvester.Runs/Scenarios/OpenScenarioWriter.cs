using System.Globalization;
using System.Xml.Linq;
using Harvester.Sessions.Scenarios;
using Harvester.Sessions.Text;

namespace Harvester.Runs.Scenarios;

/// <summary>
/// Writes a scenario as ASAM OpenSCENARIO XML 1.2: starts on lanes relative to the ego, speeds, changes of lanes, and the conditions that
/// both have. Whatever has no counterpart is refused by name.
/// </summary>
public sealed class OpenScenarioWriter
{
    /// <summary>The name of the ego's entity.</summary>
    public const string Ego = "Ego";

    private readonly Scenario _scenario;

    private OpenScenarioWriter(Scenario scenario) => _scenario = scenario;

    /// <summary>What of a scenario OpenSCENARIO cannot express, a line each; empty if it can be written.</summary>
    public static IReadOnlyList<string> Problems(Scenario scenario)
    {
        ArgumentNullException.ThrowIfNull(scenario);
        return
        [
            .. scenario
                .Actors.Where(actor => actor.Start is not { Kind: ScenarioPlaceKind.Lane, Lane: not ScenarioLane.Oncoming })
                .Select(actor => $"actor '{actor.Id}': its start must be on a lane of the ego's direction."),
            .. scenario
                .Events.Where(each => !IsKnown(each.Action.Kind) || each.Action is { Kind: ScenarioActionKind.KeepLane, Speed: null })
                .Select(each => $"event '{each.Id}': the action {JsonName.Of(each.Action.Kind)} has no counterpart."),
            .. scenario.Events.SelectMany(each =>
                each.When.Where(condition => !IsKnown(condition.Kind))
                    .Select(condition => $"event '{each.Id}': the condition {JsonName.Of(condition.Kind)} has no counterpart.")
            ),
        ];
    }

    /// <summary>The text of a file.</summary>
    /// <param name="scenario">A scenario without <see cref="Problems"/>.</param>
    /// <param name="roads">Path of the OpenDRIVE file that the scenario is to be played on; null for none.</param>
    public static string Of(Scenario scenario, string? roads)
    {
        var writer = new OpenScenarioWriter(scenario);
        return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
            + writer.Document(roads).ToString().Replace("\r\n", "\n", StringComparison.Ordinal)
            + "\n";
    }

    private static bool IsKnown(ScenarioActionKind kind) =>
        kind
            is ScenarioActionKind.KeepLane
                or ScenarioActionKind.ChangeLane
                or ScenarioActionKind.CutIn
                or ScenarioActionKind.Brake
                or ScenarioActionKind.BreakDown
                or ScenarioActionKind.SpeedProfile;

    private static bool IsKnown(ScenarioConditionKind kind) =>
        kind
            is ScenarioConditionKind.Seconds
                or ScenarioConditionKind.Distance
                or ScenarioConditionKind.TimeToCollision
                or ScenarioConditionKind.EgoFaster
                or ScenarioConditionKind.EgoSlower
                or ScenarioConditionKind.ActorSlower
                or ScenarioConditionKind.Begun
                or ScenarioConditionKind.Ended;

    private XElement Document(string? roads) =>
        new(
            "OpenSCENARIO",
            new XElement(
                "FileHeader",
                new XAttribute("revMajor", 1),
                new XAttribute("revMinor", 2),
                new XAttribute("date", "2000-01-01T00:00:00"),
                new XAttribute("description", $"{_scenario.Name} ({_scenario.Kind}): {_scenario.Description}"),
                new XAttribute("author", "GtaDataHarvester")
            ),
            new XElement("CatalogLocations"),
            new XElement("RoadNetwork", roads is null ? null : new XElement("LogicFile", new XAttribute("filepath", roads))),
            new XElement(
                "Entities",
                OpenScenarioEntities.Of(Ego, ScenarioActorType.Vehicle, "car"),
                _scenario.Actors.Select(actor => OpenScenarioEntities.Of(actor.Id, actor.Type, actor.Model))
            ),
            new XElement(
                "Storyboard",
                new XElement(
                    "Init",
                    new XElement(
                        "Actions",
                        new XElement("Private", new XAttribute("entityRef", Ego), Private(SpeedAction(_scenario.Ego.Speed, null))),
                        _scenario.Actors.Select(InitOf)
                    )
                ),
                _scenario.Events.Count == 0 ? null : StoryOf(),
                new XElement("StopTrigger", new XElement("ConditionGroup", OpenScenarioConditions.AtTime("end", _scenario.End.Seconds, 0)))
            )
        );

    private XElement InitOf(ScenarioActor actor)
    {
        // Lanes are counted to the left in OpenSCENARIO, and offsets too.
        int lanes = actor.Start.Lane switch
        {
            ScenarioLane.Left => 1,
            ScenarioLane.Right => -1,
            _ => 0,
        };
        var position = new XElement(
            "RelativeLanePosition",
            new XAttribute("entityRef", Ego),
            new XAttribute("dLane", lanes),
            Number("ds", actor.Start.MetresAhead),
            Number("offset", -actor.Start.MetresRight),
            new XElement("Orientation", new XAttribute("type", "relative"), Number("h", actor.Start.HeadingDegrees * Math.PI / 180))
        );
        return new XElement(
            "Private",
            new XAttribute("entityRef", actor.Id),
            Private(new XElement("TeleportAction", new XElement("Position", position))),
            Private(SpeedAction(actor.Speed ?? _scenario.Ego.Speed, null))
        );
    }

    private XElement StoryOf() =>
        new(
            "Story",
            new XAttribute("name", "story"),
            new XElement(
                "Act",
                new XAttribute("name", "act"),
                _scenario
                    .Events.GroupBy(each => each.Actor)
                    .Select(group => new XElement(
                        "ManeuverGroup",
                        new XAttribute("name", $"group-{group.Key}"),
                        new XAttribute("maximumExecutionCount", 1),
                        new XElement(
                            "Actors",
                            new XAttribute("selectTriggeringEntities", "false"),
                            new XElement("EntityRef", new XAttribute("entityRef", group.Key))
                        ),
                        new XElement("Maneuver", new XAttribute("name", $"maneuver-{group.Key}"), group.Select(EventOf))
                    )),
                new XElement("StartTrigger", new XElement("ConditionGroup", OpenScenarioConditions.AtTime("begin", 0, 0)))
            )
        );

    private XElement EventOf(ScenarioEvent each)
    {
        XElement[] conditions =
        [
            .. each.When.Select(
                (condition, index) =>
                    OpenScenarioConditions.Of(condition, $"{each.Id}-{index.ToString(CultureInfo.InvariantCulture)}", each)
            ),
        ];
        XElement[] groups =
            conditions.Length == 0 ? [new XElement("ConditionGroup", OpenScenarioConditions.AtTime($"{each.Id}-0", 0, each.Delay))]
            : each.IsAny ? [.. conditions.Select(condition => new XElement("ConditionGroup", condition))]
            : [new XElement("ConditionGroup", conditions)];
        return new XElement(
            "Event",
            new XAttribute("name", each.Id),
            new XAttribute("priority", "override"),
            new XAttribute("maximumExecutionCount", 1),
            new XElement("Action", new XAttribute("name", $"action-{each.Id}"), Private(ActionOf(each))),
            new XElement("StartTrigger", groups)
        );
    }

    private static XElement ActionOf(ScenarioEvent each)
    {
        ScenarioAction action = each.Action;
        return action.Kind switch
        {
            ScenarioActionKind.ChangeLane => LaneChange(each.Actor, action.Side < 0 ? 1 : -1, action.Seconds),
            ScenarioActionKind.CutIn => LaneChange(Ego, 0, action.Seconds),
            ScenarioActionKind.SpeedProfile => new XElement(
                "LongitudinalAction",
                new XElement(
                    "SpeedProfileAction",
                    new XAttribute("followingMode", "position"),
                    action.Profile.Select(
                        (point, index) =>
                            new XElement(
                                "SpeedProfileEntry",
                                Number("speed", point.Speed),
                                Number("time", point.Seconds - (index == 0 ? 0 : action.Profile[index - 1].Seconds))
                            )
                    )
                )
            ),
            _ => SpeedAction(action.Speed ?? 0, action.Acceleration),
        };
    }

    private static XElement LaneChange(string relativeTo, int lanes, double seconds) =>
        new(
            "LateralAction",
            new XElement(
                "LaneChangeAction",
                new XElement(
                    "LaneChangeActionDynamics",
                    new XAttribute("dynamicsShape", "sinusoidal"),
                    new XAttribute("dynamicsDimension", "time"),
                    Number("value", seconds)
                ),
                new XElement(
                    "LaneChangeTarget",
                    new XElement("RelativeTargetLane", new XAttribute("entityRef", relativeTo), new XAttribute("value", lanes))
                )
            )
        );

    /// <summary>A change of speed at a rate, m/s²; at once without one.</summary>
    private static XElement SpeedAction(double speed, double? rate) =>
        new(
            "LongitudinalAction",
            new XElement(
                "SpeedAction",
                new XElement(
                    "SpeedActionDynamics",
                    new XAttribute("dynamicsShape", rate is null ? "step" : "linear"),
                    new XAttribute("dynamicsDimension", rate is null ? "time" : "rate"),
                    Number("value", rate ?? 0)
                ),
                new XElement("SpeedActionTarget", new XElement("AbsoluteTargetSpeed", Number("value", speed)))
            )
        );

    private static XElement Private(XElement action) => new("PrivateAction", action);

    /// <summary>A number as an attribute.</summary>
    internal static XAttribute Number(string name, double value) => new(name, value.ToString("R", CultureInfo.InvariantCulture));
}
