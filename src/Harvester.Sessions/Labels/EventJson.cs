using Harvester.Geometry;
using Harvester.Sessions.Events;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes an event as one line of JSON. Fields, units and ranges: docs/events.md.</summary>
public static class EventJson
{
    /// <summary>Decimals of impulses, N·s.</summary>
    private const int ImpulseDecimals = 1;

    /// <summary>The line of an event, without the end of the line.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or too large to be written.</exception>
    public static string Line(DrivingEvent happened)
    {
        if (happened is null)
        {
            throw new ArgumentNullException(nameof(happened));
        }

        var json = new JsonText();
        json.BeginObject()
            .Key("id")
            .Integer(happened.Id)
            .Key("kind")
            .String(JsonName.Of(happened.Kind))
            .Key("beginSeconds")
            .Number(happened.BeginSeconds, LabelDecimals.Seconds)
            .Key("peakSeconds")
            .Number(happened.PeakSeconds, LabelDecimals.Seconds)
            .Key("endSeconds")
            .Number(happened.EndSeconds, LabelDecimals.Seconds)
            .Key("end")
            .String(JsonName.Of(happened.End))
            .Key("firstFrame")
            .Integer(happened.FirstFrame)
            .Key("lastFrame")
            .Integer(happened.LastFrame)
            .Key("participants")
            .BeginArray();
        foreach (EventParticipant participant in happened.Participants)
        {
            Append(json, participant);
        }

        json.EndArray().Key("measures").BeginObject();
        foreach (KeyValuePair<string, double?> measure in happened.Measures)
        {
            json.Key(measure.Key).Number(measure.Value, LabelDecimals.Metres);
        }

        json.EndObject();
        if (happened.Contact is { } contact)
        {
            Append(json.Key("contact"), contact);
        }

        return json.EndObject().ToString();
    }

    /// <summary>Writes the open events of a frame as a field of the current object; nothing if events are not recorded.</summary>
    internal static void AppendMarks(JsonText json, IReadOnlyList<EventMark>? marks)
    {
        if (marks is null)
        {
            return;
        }

        json.Key("events").BeginArray();
        foreach (EventMark mark in marks)
        {
            json.BeginObject().Key("id").Integer(mark.Id).Key("kind").String(JsonName.Of(mark.Kind)).EndObject();
        }

        json.EndArray();
    }

    private static void Append(JsonText json, EventParticipant participant) =>
        json.BeginObject()
            .Key("object")
            .Integer(participant.Object)
            .Key("class")
            .String(participant.Class is { } known ? JsonName.Of(known) : null)
            .Key("model")
            .String(participant.Model)
            .Key("position")
            .Vector(participant.Pose.Position, LabelDecimals.Metres)
            .Key("right")
            .Vector(participant.Pose.Axes.Right, LabelDecimals.Axis)
            .Key("forward")
            .Vector(participant.Pose.Axes.Forward, LabelDecimals.Axis)
            .Key("up")
            .Vector(participant.Pose.Axes.Up, LabelDecimals.Axis)
            .Key("modelMin")
            .Vector(participant.ModelMin, LabelDecimals.Metres)
            .Key("modelMax")
            .Vector(participant.ModelMax, LabelDecimals.Metres)
            .Key("velocity")
            .Vector(participant.Velocity, LabelDecimals.Speed)
            .Key("yawRate")
            .Number(participant.YawRate, LabelDecimals.Seconds)
            .EndObject();

    private static void Append(JsonText json, EventContact contact)
    {
        json.BeginObject().Key("position").Vector(contact.Position, LabelDecimals.Metres);
        Append(json.Key("onFirst"), contact.OnFirst);
        Append(json.Key("onSecond"), contact.OnSecond);
        json.Key("relativeSpeed")
            .Number(contact.RelativeSpeed, LabelDecimals.Speed)
            .Key("firstSpeedChange")
            .Number(contact.FirstSpeedChange, LabelDecimals.Speed)
            .Key("secondSpeedChange")
            .Number(contact.SecondSpeedChange, LabelDecimals.Speed)
            .Key("impulse")
            .Number(contact.Impulse, ImpulseDecimals)
            .Key("impulseMin")
            .Number(contact.ImpulseMin, ImpulseDecimals)
            .Key("impulseMax")
            .Number(contact.ImpulseMax, ImpulseDecimals)
            .EndObject();
    }

    private static void Append(JsonText json, Vector2D place) =>
        json.BeginArray().Number(place.X, LabelDecimals.Metres).Number(place.Y, LabelDecimals.Metres).EndArray();
}
