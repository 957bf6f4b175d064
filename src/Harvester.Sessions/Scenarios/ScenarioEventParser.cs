using Harvester.Geometry.Maps;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Scenarios;

/// <summary>Reads what an actor does, and when.</summary>
internal static class ScenarioEventParser
{
    private const int MaxConditions = 20;
    private const int MaxPoints = 1000;
    private const double Fastest = 60;
    private const double World = 20_000;

    /// <summary>Reads an event.</summary>
    /// <param name="item">The object.</param>
    /// <param name="actors">The ids of the actors.</param>
    public static ScenarioEvent Read(CheckedJson item, IReadOnlyCollection<string> actors)
    {
        string actor = ActorIn(item, actors);
        CheckedJson when = item.Fields("when") ?? CheckedJson.Parse("{}", "a scenario");
        if (when.Has("all") && when.Has("any"))
        {
            throw when.Wrong("any", "left out where all is given");
        }

        bool isAny = when.Has("any");
        CheckedJson[] conditions = when.List(isAny ? "any" : "all");
        _ = when.List("all");
        when.End();
        return conditions.Length <= MaxConditions
            ? new ScenarioEvent(
                ScenarioParser.NameOf(item, "id"),
                actor,
                ActionOf(item.Fields("do") ?? throw item.Wrong("do", "an object"))
            )
            {
                When = [.. conditions.Select(condition => ConditionOf(condition, actors))],
                IsAny = isAny,
                Delay = item.Number("delay", 0, 600, 0),
            }
            : throw item.Wrong("when", "of at most 20 conditions");
    }

    private static string ActorIn(CheckedJson item, IReadOnlyCollection<string> actors)
    {
        string actor = item.Text("actor");
        return actors.Contains(actor) ? actor : throw item.Wrong("actor", $"the id of an actor, not '{actor}'");
    }

    private static ScenarioCondition ConditionOf(CheckedJson condition, IReadOnlyCollection<string> actors)
    {
        ScenarioConditionKind[] kinds =
        [
            .. Enum.GetValues(typeof(ScenarioConditionKind)).Cast<ScenarioConditionKind>().Where(kind => condition.Has(JsonName.Of(kind))),
        ];
        if (kinds.Length != 1)
        {
            throw condition.Wrong(
                "seconds",
                "or another condition, one in each object: "
                    + string.Join(
                        ", ",
                        Enum.GetValues(typeof(ScenarioConditionKind)).Cast<ScenarioConditionKind>().Select(kind => JsonName.Of(kind))
                    )
            );
        }

        string name = JsonName.Of(kinds[0]);
        ScenarioCondition made = kinds[0] switch
        {
            ScenarioConditionKind.Begun or ScenarioConditionKind.Ended => new(kinds[0], 0) { Event = condition.Text(name) },
            ScenarioConditionKind.Light => new(kinds[0], 0) { Light = condition.Choice<LightState>(name) },
            ScenarioConditionKind.Distance
            or ScenarioConditionKind.TimeToCollision
            or ScenarioConditionKind.ActorSlower
            or ScenarioConditionKind.Ahead => new(kinds[0], condition.Number(name, -500, 500)) { Actor = ActorIn(condition, actors) },
            ScenarioConditionKind.EgoArrival => new(kinds[0], condition.Number(name, 0, 500))
            {
                Actor = condition.Has("actor") ? ActorIn(condition, actors) : null,
            },
            _ => new(kinds[0], condition.Number(name, 0, 600)),
        };
        return ScenarioParser.Ended(condition, made);
    }

    private static ScenarioAction ActionOf(CheckedJson fields)
    {
        ScenarioActionKind kind = fields.Choice<ScenarioActionKind>("action");
        var action = new ScenarioAction(kind)
        {
            Speed = fields.Has("speed") ? fields.Number("speed", 0, Fastest) : null,
            Acceleration = fields.Number("acceleration", 0.1, 20, 3),
        };
        action = kind switch
        {
            ScenarioActionKind.ChangeLane or ScenarioActionKind.PullOut or ScenarioActionKind.Park => action with
            {
                Side = StartParser.SideOf(fields, "side"),
                Seconds = fields.Number("seconds", 0.5, 30, 3),
            },
            ScenarioActionKind.CutIn => action with { Seconds = fields.Number("seconds", 0.5, 30, 2) },
            ScenarioActionKind.Cross => action with
            {
                Degrees = fields.Number("degrees", -360, 360, 90),
                Metres = fields.Number("metres", 0.5, 300, 20),
            },
            ScenarioActionKind.Reverse => action with { Metres = fields.Number("metres", 0.5, 100, 10) },
            ScenarioActionKind.RunJunction => action with { Turn = fields.Choice("turn", MapTurn.Straight) },
            ScenarioActionKind.OpenDoor => action with { Side = StartParser.SideOf(fields, "side") },
            ScenarioActionKind.SpeedProfile => action with { Profile = ProfileOf(fields) },
            ScenarioActionKind.FollowPath => action with
            {
                Points = PointsOf(fields),
                IsWorld = fields.Text("frame", "ego") switch
                {
                    "ego" => false,
                    "world" => true,
                    _ => throw fields.Wrong("frame", "ego or world"),
                },
            },
            _ => action,
        };
        return ScenarioParser.Ended(fields, action);
    }

    private static Geometry.Vector2D[] PointsOf(CheckedJson fields)
    {
        Geometry.Vector2D[] points = fields.Points("points", World);
        return points.Length is >= 2 and <= MaxPoints && points.Zip(points.Skip(1), (a, b) => (b - a).Length).All(length => length > 0)
            ? points
            : throw fields.Wrong("points", "a list of 2 to 1000 points, each unlike the one before");
    }

    private static (double Seconds, double Speed)[] ProfileOf(CheckedJson fields)
    {
        (double Seconds, double Speed)[] profile = [.. fields.Points("profile", 600).Select(point => (point.X, point.Y))];
        return
            profile.Length is >= 1 and <= MaxPoints
            && profile.All(point => point.Seconds >= 0 && point.Speed is >= 0 and <= Fastest)
            && profile.Zip(profile.Skip(1), (a, b) => b.Seconds - a.Seconds).All(seconds => seconds > 0)
            ? profile
            : throw fields.Wrong("profile", "a list of [seconds, speed], with ascending seconds and speeds from 0 to 60");
    }
}
