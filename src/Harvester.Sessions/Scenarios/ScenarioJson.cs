using Harvester.Geometry;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Scenarios;

/// <summary>
/// Writes a scenario as <see cref="ScenarioParser"/> reads it, with the values of its parameters in place of their names.
/// </summary>
public static class ScenarioJson
{
    /// <summary>The text of a file.</summary>
    public static string Of(Scenario scenario)
    {
        var json = new JsonText(indented: true);
        Append(json, scenario);
        return json + "\n";
    }

    internal static void Append(JsonText json, Scenario scenario)
    {
        json.BeginObject().Key("name").String(scenario.Name).Key("kind").String(scenario.Kind);
        json.Key("description").String(scenario.Description).Key("parameters").BeginObject();
        foreach (KeyValuePair<string, double> value in scenario.Values)
        {
            json.Key(value.Key).Exact(value.Value);
        }

        json.EndObject().Key("ego").BeginObject().Key("speed").Exact(scenario.Ego.Speed);
        json.Key("turn").String(JsonName.Of(scenario.Ego.Turn)).EndObject();
        AppendNeeds(json.Key("place"), scenario.Place);
        json.Key("actors").BeginArray();
        foreach (ScenarioActor actor in scenario.Actors)
        {
            AppendActor(json, actor);
        }

        json.EndArray().Key("events").BeginArray();
        foreach (ScenarioEvent each in scenario.Events)
        {
            AppendEvent(json, each);
        }

        json.EndArray().Key("end").BeginObject().Key("seconds").Exact(scenario.End.Seconds);
        Optional(json, "metres", scenario.End.Metres);
        json.Key("egoPassedAll")
            .Boolean(scenario.End.EgoPassedAll)
            .Key("collision")
            .Boolean(scenario.End.Collision)
            .EndObject()
            .EndObject();
    }

    private static void AppendNeeds(JsonText json, ScenarioNeeds needs)
    {
        json.BeginObject().Key("lanes").Integer(needs.Lanes).Key("lanesLeft").Integer(needs.LanesLeft);
        json.Key("lanesRight").Integer(needs.LanesRight).Key("oncomingLane").Boolean(needs.OncomingLane);
        json.Key("street").Boolean(needs.Street).Key("straightMetres").Exact(needs.StraightMetres).Key("metres").Exact(needs.Metres);
        if (needs.Crossing is { } crossing)
        {
            json.Key("crossing").BeginArray().Exact(crossing.From).Exact(crossing.To).EndArray();
        }

        if (needs.Junction is { } junction)
        {
            json.Key("junction").BeginObject().Key("within").BeginArray().Exact(junction.From).Exact(junction.To).EndArray();
            if (junction.Light is { } light)
            {
                json.Key("light").Boolean(light);
            }

            json.Key("approaches").BeginArray();
            foreach (ScenarioApproach approach in junction.Approaches)
            {
                json.String(JsonName.Of(approach));
            }

            json.EndArray().EndObject();
        }

        json.EndObject();
    }

    private static void AppendActor(JsonText json, ScenarioActor actor)
    {
        ScenarioStart start = actor.Start;
        json.BeginObject().Key("id").String(actor.Id).Key("type").String(JsonName.Of(actor.Type)).Key("model").String(actor.Model);
        json.Key("start").BeginObject();
        switch (start.Kind)
        {
            case ScenarioPlaceKind.Lane:
                json.Key("metresAhead").Exact(start.MetresAhead).Key("lane").String(JsonName.Of(start.Lane));
                break;
            case ScenarioPlaceKind.Roadside:
                json.Key("roadside").String(JsonName.Of(start.Strip)).Key("side").String(SideOf(start.Side));
                json.Key("metresAhead").Exact(start.MetresAhead);
                break;
            case ScenarioPlaceKind.Crossing:
                json.Key("crossing").String(SideOf(start.Side));
                break;
            case ScenarioPlaceKind.Junction:
                json.Key("approach").String(JsonName.Of(start.Approach));
                Optional(json, "metresBefore", start.MetresBefore);
                Optional(json, "secondsBefore", start.SecondsBefore);
                break;
            default:
                json.Key("x").Exact(start.Point.X).Key("y").Exact(start.Point.Y);
                break;
        }

        json.Key("metresRight").Exact(start.MetresRight);
        if (start.Kind != ScenarioPlaceKind.Junction)
        {
            json.Key("headingDegrees").Exact(start.HeadingDegrees);
        }

        json.EndObject();
        Optional(json, "speed", actor.Speed);
        json.Key("ignoresOthers").Boolean(actor.IgnoresOthers).EndObject();
    }

    private static void AppendEvent(JsonText json, ScenarioEvent each)
    {
        json.BeginObject().Key("id").String(each.Id).Key("actor").String(each.Actor).Key("when").BeginObject();
        json.Key(each.IsAny ? "any" : "all").BeginArray();
        foreach (ScenarioCondition condition in each.When)
        {
            json.BeginObject().Key(JsonName.Of(condition.Kind));
            _ =
                condition.Event is { } other ? json.String(other)
                : condition.Kind == ScenarioConditionKind.Light ? json.String(JsonName.Of(condition.Light))
                : json.Exact(condition.Value);
            if (condition.Actor is { } actor)
            {
                json.Key("actor").String(actor);
            }

            json.EndObject();
        }

        json.EndArray().EndObject().Key("delay").Exact(each.Delay).Key("do");
        AppendAction(json, each.Action);
        json.EndObject();
    }

    private static void AppendAction(JsonText json, ScenarioAction action)
    {
        json.BeginObject().Key("action").String(JsonName.Of(action.Kind));
        Optional(json, "speed", action.Speed);
        json.Key("acceleration").Exact(action.Acceleration);
        switch (action.Kind)
        {
            case ScenarioActionKind.ChangeLane or ScenarioActionKind.PullOut or ScenarioActionKind.Park:
                json.Key("side").String(SideOf(action.Side)).Key("seconds").Exact(action.Seconds);
                break;
            case ScenarioActionKind.CutIn:
                json.Key("seconds").Exact(action.Seconds);
                break;
            case ScenarioActionKind.Cross:
                json.Key("degrees").Exact(action.Degrees).Key("metres").Exact(action.Metres);
                break;
            case ScenarioActionKind.Reverse:
                json.Key("metres").Exact(action.Metres);
                break;
            case ScenarioActionKind.RunJunction:
                json.Key("turn").String(JsonName.Of(action.Turn));
                break;
            case ScenarioActionKind.OpenDoor:
                json.Key("side").String(SideOf(action.Side));
                break;
            case ScenarioActionKind.SpeedProfile:
                AppendPoints(json.Key("profile"), action.Profile.Select(point => new Vector2D(point.Seconds, point.Speed)));
                break;
            case ScenarioActionKind.FollowPath:
                AppendPoints(json.Key("frame").String(action.IsWorld ? "world" : "ego").Key("points"), action.Points);
                break;
            default:
                break;
        }

        json.EndObject();
    }

    private static void AppendPoints(JsonText json, IEnumerable<Vector2D> points)
    {
        json.BeginArray();
        foreach (Vector2D point in points)
        {
            json.BeginArray().Exact(point.X).Exact(point.Y).EndArray();
        }

        json.EndArray();
    }

    private static void Optional(JsonText json, string name, double? value)
    {
        if (value is { } known)
        {
            json.Key(name).Exact(known);
        }
    }

    private static string SideOf(int side) => side < 0 ? "left" : "right";
}
