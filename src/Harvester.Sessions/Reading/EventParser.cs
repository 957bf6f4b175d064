using System.Text.Json;
using Harvester.Geometry;
using Harvester.Sessions.Events;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Reading;

/// <summary>Reads a line of events.jsonl, as docs/events.md describes it. Unknown fields are ignored.</summary>
public static class EventParser
{
    /// <summary>More road users than an event can have.</summary>
    private const int MaxParticipants = 2;

    /// <exception cref="DatasetFormatException">The line is not a valid event; the message names the field.</exception>
    public static DrivingEvent Parse(string line)
    {
        try
        {
            using JsonDocument document = JsonInput.Parse(line);
            return Read(new JsonFields(document.RootElement));
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException(JsonFault.InLine(e), e);
        }
    }

    /// <summary>The open events of a label; null if it has none of the field.</summary>
    /// <exception cref="DatasetFormatException">A field is invalid.</exception>
    internal static IReadOnlyList<EventMark>? Marks(JsonFields frame) =>
        frame.Has("events")
            ? [.. frame.List("events").Select(mark => new EventMark(mark.Integer("id"), mark.Name<EventKind>("kind")))]
            : null;

    private static DrivingEvent Read(JsonFields line)
    {
        IReadOnlyList<JsonFields> participants = line.List("participants");
        if (participants.Count is < 1 or > MaxParticipants)
        {
            throw new DatasetFormatException(
                FormattableString.Invariant($"participants has {participants.Count} entries; it must have 1 or {MaxParticipants}.")
            );
        }

        JsonFields measures = line.Fields("measures");
        return new DrivingEvent(
            line.Integer("id"),
            line.Name<EventKind>("kind"),
            line.Number("beginSeconds"),
            line.Number("peakSeconds"),
            line.Number("endSeconds"),
            line.Name<EventEnd>("end"),
            [.. participants.Select(ReadParticipant)]
        )
        {
            FirstFrame = line.Has("firstFrame") ? line.Integer("firstFrame") : null,
            LastFrame = line.Has("lastFrame") ? line.Integer("lastFrame") : null,
            Measures = [.. measures.Names.Select(name => KeyValuePair.Create(name, measures.OptionalNumber(name)))],
            Contact = line.Has("contact") ? ReadContact(line.Fields("contact")) : null,
        };
    }

    private static EventParticipant ReadParticipant(JsonFields participant) =>
        new(
            participant.Has("object") ? participant.Integer("object") : null,
            participant.Has("class") ? participant.Name<ObjectClass>("class") : null,
            participant.Text("model"),
            new Pose(participant.Vector("position"), participant.Axes()),
            participant.Vector("modelMin"),
            participant.Vector("modelMax"),
            participant.Vector("velocity"),
            participant.Number("yawRate")
        );

    private static EventContact ReadContact(JsonFields contact) =>
        new(
            contact.Vector("position"),
            PlaceOf(contact, "onFirst"),
            PlaceOf(contact, "onSecond"),
            contact.Number("relativeSpeed"),
            contact.Number("firstSpeedChange"),
            contact.Number("secondSpeedChange"),
            contact.Number("impulse"),
            contact.Number("impulseMin"),
            contact.Number("impulseMax")
        );

    private static Vector2D PlaceOf(JsonFields contact, string name)
    {
        double[] place = contact.Numbers(name, 2);
        return new Vector2D(place[0], place[1]);
    }
}
