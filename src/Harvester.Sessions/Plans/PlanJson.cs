using System.Globalization;
using Harvester.Geometry;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Plans;

/// <summary>Writes a plan as <see cref="PlanParser"/> reads it, with every value in full.</summary>
public static class PlanJson
{
    /// <summary>The text of the file.</summary>
    public static string Of(Plan plan)
    {
        JsonText json = new JsonText(indented: true)
            .BeginObject()
            .Key("name")
            .String((plan ?? throw new ArgumentNullException(nameof(plan))).Name)
            .Key("seed")
            .Integer(plan.Seed)
            .Key("places")
            .BeginArray();
        foreach (PlanPlace place in plan.Places)
        {
            Append(json, place);
        }

        json.EndArray().Key("weathers").BeginArray();
        foreach (string weather in plan.Weathers)
        {
            json.String(weather);
        }

        json.EndArray().Key("hours").BeginArray();
        foreach (TimeSpan hour in plan.Hours)
        {
            json.String(hour.ToString(@"hh\:mm", CultureInfo.InvariantCulture));
        }

        json.EndArray().Key("cameras").BeginArray();
        foreach (PlanCamera camera in plan.Cameras)
        {
            json.BeginObject().Key("name").String(camera.Name);
            _ = camera.RigFile is { } rig
                ? json.Key("rig").String(rig)
                : json.Key("width")
                    .Integer(camera.Image.Width)
                    .Key("height")
                    .Integer(camera.Image.Height)
                    .Key("verticalFovDegrees")
                    .Exact(camera.VerticalFovDegrees);
            json.EndObject();
        }

        json.EndArray()
            .Key("repetitions")
            .Integer(plan.Repetitions)
            .Key("frames")
            .Integer(plan.Frames)
            .Key("hz")
            .Exact(plan.Hz)
            .Key("speed")
            .Exact(plan.SpeedMetresPerSecond)
            .Key("traffic")
            .Exact(plan.Traffic)
            .Key("pedestrians")
            .Exact(plan.Pedestrians)
            .Key("parked")
            .Exact(plan.Parked)
            .Key("masks")
            .String(JsonName.Of(plan.Masks));
        if (plan.Events)
        {
            json.Key("events").Boolean(true);
        }

        return json.EndObject() + "\n";
    }

    private static void Append(JsonText json, PlanPlace place)
    {
        json.BeginObject().Key("name").String(place.Name);
        if (place.Path.Count > 0)
        {
            json.Key("path").BeginArray();
            foreach (Vector2D point in place.Path)
            {
                json.BeginArray().Exact(point.X).Exact(point.Y).EndArray();
            }

            json.EndArray();
        }
        else if (place.Point is { } point)
        {
            json.Key("x").Exact(point.X).Key("y").Exact(point.Y);
        }
        else if (place.Space is { } space)
        {
            json.Key("space").String(space).Key("metresBefore").Exact(place.MetresBefore);
        }
        else if (place.Spread is { } spread)
        {
            json.Key("spread").Integer(spread);
        }

        if (place.Scenario is { } scenario)
        {
            json.Key("scenario").String(scenario);
        }

        Append(json, "headingDegrees", place.HeadingDegrees);
        Append(json, "seconds", place.Seconds);
        Append(json, "metres", place.Metres);
        json.EndObject();
    }

    private static void Append(JsonText json, string name, double? value)
    {
        if (value is { } known)
        {
            json.Key(name).Exact(known);
        }
    }
}
