using System.Text.RegularExpressions;
using System.Xml.Linq;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenarios;

namespace Harvester.Runs.Scenarios;

/// <summary>
/// Reads what <see cref="OpenScenarioWriter"/> writes of ASAM OpenSCENARIO XML 1.0 to 1.3. Whatever else a file has is refused by its line,
/// except for the ego's place, catalogs, the road network and the sizes of entities, which are left out.
/// </summary>
public sealed class OpenScenarioReader
{
    /// <summary>The greatest number of characters of a file.</summary>
    private const int MaxCharacters = 4_000_000;

    /// <summary>As the description of a written file says name and kind.</summary>
    private static readonly Regex Described = new(
        @"\A([A-Za-z0-9-]{1,30}) \(([A-Za-z0-9-]{1,30})\): (.*)\z",
        RegexOptions.CultureInvariant | RegexOptions.Singleline
    );

    private readonly XElement _root;
    private readonly Dictionary<string, double> _speeds = new(StringComparer.Ordinal);
    private readonly Dictionary<string, ScenarioStart> _starts = new(StringComparer.Ordinal);

    private OpenScenarioReader(XElement root) => _root = root;

    /// <summary>Reads a file.</summary>
    /// <param name="text">Its text.</param>
    /// <param name="name">The name of the scenario if the file does not say it.</param>
    /// <returns>The text of a scenario file without problems.</returns>
    /// <exception cref="DatasetFormatException">The file is not XML, or has something that a scenario has no counterpart of; the message
    /// names the line.</exception>
    public static string Read(string text, string name)
    {
        ArgumentNullException.ThrowIfNull(text);
        XElement root = OpenScenarioXml.Load(text, MaxCharacters);
        if (root.Name != "OpenSCENARIO")
        {
            throw OpenScenarioXml.Wrong(root, "the outermost element must be OpenSCENARIO.");
        }

        string made = ScenarioJson.Of(new OpenScenarioReader(root).Scenario(name));
        ScenarioReading reading = ScenarioParser.Read(made);
        return reading.Template is not null
            ? made
            : throw new DatasetFormatException($"what it says makes no scenario: {reading.Problems[0]}");
    }

    private Scenario Scenario(string name)
    {
        XElement header = _root.The("FileHeader");
        if (header.Text("revMajor") != "1")
        {
            throw OpenScenarioXml.Wrong(header, $"its version is {header.Text("revMajor")}; 1.0 to 1.3 are read.");
        }

        string description = header.Attribute("description")?.Value ?? "";
        Match described = Described.Match(description);
        XElement storyboard = _root.The("Storyboard");
        foreach (XElement entity in storyboard.The("Init").The("Actions").Elements())
        {
            ReadInit(entity);
        }

        ScenarioActor[] actors = [.. _root.The("Entities").Elements().Select(ActorOf).OfType<ScenarioActor>()];
        ScenarioEvent[] events = [.. storyboard.Elements("Story").SelectMany(EventsOf)];
        return new Scenario(
            described.Success ? described.Groups[1].Value : name,
            described.Success ? described.Groups[2].Value : "imported",
            actors,
            events
        )
        {
            Description = described.Success ? described.Groups[3].Value : description,
            Ego = new ScenarioEgo
            {
                Speed = _speeds.TryGetValue(OpenScenarioWriter.Ego, out double speed)
                    ? speed
                    : throw OpenScenarioXml.Wrong(storyboard, $"Init must give '{OpenScenarioWriter.Ego}' a speed."),
            },
            Place = new ScenarioNeeds
            {
                LanesLeft = actors.Any(actor => actor.Start.Lane == ScenarioLane.Left) ? 1 : 0,
                LanesRight = actors.Any(actor => actor.Start.Lane == ScenarioLane.Right) ? 1 : 0,
            },
            End = EndOf(storyboard),
        };
    }

    private static ScenarioEnd EndOf(XElement storyboard)
    {
        XElement[] conditions = [.. storyboard.Elements("StopTrigger").SelectMany(trigger => trigger.Descendants("Condition"))];
        return conditions switch
        {
            [] => new ScenarioEnd(),
            [var one] when OpenScenarioTriggers.Of(one) is { Kind: ScenarioConditionKind.Seconds, Value: var seconds } => new ScenarioEnd
            {
                Seconds = seconds,
            },
            _ => throw OpenScenarioXml.Wrong(conditions[0], "StopTrigger may have one condition, on the time."),
        };
    }

    private void ReadInit(XElement entity)
    {
        if (entity.Name != "Private")
        {
            throw OpenScenarioXml.Unsupported(entity);
        }

        string name = entity.Text("entityRef");
        foreach (XElement action in entity.Elements("PrivateAction").Select(OpenScenarioXml.Only))
        {
            switch (action.Name.LocalName)
            {
                case "TeleportAction" when name == OpenScenarioWriter.Ego:
                    break;
                case "TeleportAction":
                    _starts[name] = StartOf(action.The("Position").Only());
                    break;
                case "LongitudinalAction" when action.Only() is { Name.LocalName: "SpeedAction" } speed:
                    _speeds[name] = TargetOf(speed);
                    break;
                default:
                    throw OpenScenarioXml.Unsupported(action);
            }
        }
    }

    private static ScenarioStart StartOf(XElement position)
    {
        if (position.Name != "RelativeLanePosition" || position.Text("entityRef") != OpenScenarioWriter.Ego)
        {
            throw OpenScenarioXml.Wrong(position, $"a position must be a RelativeLanePosition of '{OpenScenarioWriter.Ego}'.");
        }

        XElement? orientation = position.Element("Orientation");
        return new ScenarioStart(ScenarioPlaceKind.Lane)
        {
            MetresAhead = position.Number("ds"),
            MetresRight = -position.Number("offset", 0),
            Lane = position.Number("dLane") switch
            {
                0 => ScenarioLane.Ego,
                1 => ScenarioLane.Left,
                -1 => ScenarioLane.Right,
                _ => throw OpenScenarioXml.Wrong(position, "dLane must be -1, 0 or 1."),
            },
            HeadingDegrees = (orientation?.Number("h", 0) ?? 0) * 180 / Math.PI,
        };
    }

    private ScenarioActor? ActorOf(XElement entity)
    {
        string name = entity.Text("name");
        if (name == OpenScenarioWriter.Ego)
        {
            return null;
        }

        XElement body = entity.Only();
        (ScenarioActorType type, string model) = OpenScenarioEntities.TypeOf(body);
        return new ScenarioActor(
            name,
            type,
            OpenScenarioEntities.ModelOf(body) ?? model,
            _starts.TryGetValue(name, out ScenarioStart? start)
                ? start
                : throw OpenScenarioXml.Wrong(entity, $"Init must say where '{name}' is."),
            _speeds.GetValueOrDefault(name)
        );
    }

    private static IEnumerable<ScenarioEvent> EventsOf(XElement story) =>
        from act in story.Elements("Act")
        from grouped in act.Elements("ManeuverGroup")
        let actor = grouped.The("Actors").The("EntityRef").Text("entityRef")
        from maneuver in grouped.Elements("Maneuver")
        from each in maneuver.Elements("Event")
        select EventOf(each, actor);

    private static ScenarioEvent EventOf(XElement each, string actor)
    {
        XElement[] groups = [.. each.The("StartTrigger").Elements("ConditionGroup")];
        XElement[] conditions = [.. groups.Elements("Condition")];
        bool isAny = groups.Length > 1;
        if (isAny && conditions.Length != groups.Length)
        {
            throw OpenScenarioXml.Wrong(each, "several groups of conditions may have one condition each.");
        }

        double[] delays = [.. conditions.Select(condition => condition.Number("delay", 0)).Distinct()];
        if (delays.Length > 1)
        {
            throw OpenScenarioXml.Wrong(each, "all conditions of an event must have the same delay.");
        }

        ScenarioCondition[] when = [.. conditions.Select(OpenScenarioTriggers.Of)];
        return new ScenarioEvent(each.Text("name"), actor, ActionOf(each.The("Action").The("PrivateAction").Only(), actor))
        {
            When = when is [{ Kind: ScenarioConditionKind.Seconds, Value: 0 }] ? [] : when,
            IsAny = isAny,
            Delay = delays.FirstOrDefault(),
        };
    }

    private static ScenarioAction ActionOf(XElement action, string actor)
    {
        XElement inner = action.Only();
        switch (inner.Name.LocalName)
        {
            case "SpeedAction" when inner.The("SpeedActionDynamics") is var dynamics && dynamics.Text("dynamicsDimension") == "rate":
                double speed = TargetOf(inner);
                return new ScenarioAction(speed == 0 ? ScenarioActionKind.Brake : ScenarioActionKind.KeepLane)
                {
                    Speed = speed,
                    Acceleration = dynamics.Number("value"),
                };
            case "SpeedAction":
                throw OpenScenarioXml.Wrong(inner, "the dynamicsDimension of a SpeedAction in an event must be rate.");
            case "SpeedProfileAction":
                double seconds = 0;
                return new ScenarioAction(ScenarioActionKind.SpeedProfile)
                {
                    Profile =
                    [
                        .. inner.Elements("SpeedProfileEntry").Select(entry => (seconds += entry.Number("time"), entry.Number("speed"))),
                    ],
                };
            case "LaneChangeAction":
                return LaneChange(inner, actor);
            default:
                throw OpenScenarioXml.Unsupported(inner);
        }
    }

    private static ScenarioAction LaneChange(XElement change, string actor)
    {
        XElement dynamics = change.The("LaneChangeActionDynamics");
        XElement target = change.The("LaneChangeTarget").Only();
        string? reference = target.Attribute("entityRef")?.Value;
        double lanes = target.Name == "RelativeTargetLane" ? target.Number("value") : double.NaN;
        if (dynamics.Text("dynamicsDimension") != "time")
        {
            throw OpenScenarioXml.Wrong(dynamics, "the dynamicsDimension of a change of lanes must be time.");
        }

        double seconds = dynamics.Number("value");
        return reference == OpenScenarioWriter.Ego && lanes == 0 ? new ScenarioAction(ScenarioActionKind.CutIn) { Seconds = seconds }
            : reference == actor && Math.Abs(lanes) == 1
                ? new ScenarioAction(ScenarioActionKind.ChangeLane) { Side = lanes > 0 ? -1 : 1, Seconds = seconds }
            : throw OpenScenarioXml.Wrong(
                target,
                $"the target must be one lane beside '{actor}', or the lane of '{OpenScenarioWriter.Ego}'."
            );
    }

    private static double TargetOf(XElement speed) => speed.The("SpeedActionTarget").The("AbsoluteTargetSpeed").Number("value");
}
