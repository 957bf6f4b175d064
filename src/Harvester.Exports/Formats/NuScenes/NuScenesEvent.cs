using System.Text.Json;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>An event that is open at a frame, as the tables need it.</summary>
/// <param name="Kind">Its kind, as in events.jsonl.</param>
/// <param name="Objects">The numbers of the objects that take part; <see cref="Ego"/> for the ego.</param>
internal sealed record NuScenesEvent(string Kind, IReadOnlyList<int> Objects)
{
    /// <summary>Stands for the ego, which has no number.</summary>
    public const int Ego = 0;

    /// <summary>A field of samples and annotations that nuScenes does not have: the attributes of events.</summary>
    public const string Field = "event_attribute_tokens";

    /// <summary>The name of its attribute.</summary>
    public string Attribute => "event." + Kind;

    /// <summary>The events of a session, by number.</summary>
    public static IReadOnlyDictionary<int, NuScenesEvent> In(SessionReader session) =>
        session
            .ReadEvents()
            .ToDictionary(
                each => each.Id,
                each => new NuScenesEvent(JsonName.Of(each.Kind), [.. each.Participants.Select(participant => participant.Object ?? Ego)])
            );

    /// <summary>
    /// Writes the tokens of the attributes of events in which an object takes part; nothing for a session without events.
    /// </summary>
    /// <param name="json">Receives the field.</param>
    /// <param name="events">The events of a sample; null in a session without events.</param>
    /// <param name="id">The object, or <see cref="Ego"/>.</param>
    public static void WriteTokens(Utf8JsonWriter json, IReadOnlyList<NuScenesEvent>? events, int id)
    {
        if (events is null)
        {
            return;
        }

        json.WriteStartArray(Field);
        foreach (
            string attribute in events
                .Where(each => each.Objects.Contains(id))
                .Select(each => each.Attribute)
                .Distinct()
                .Order(StringComparer.Ordinal)
        )
        {
            json.WriteStringValue(NuScenesTables.AttributeToken(attribute));
        }

        json.WriteEndArray();
    }

    /// <summary>Writes it as an object.</summary>
    public void Write(Utf8JsonWriter json)
    {
        json.WriteStartObject();
        json.WriteString("kind", Kind);
        json.WriteStartArray("objects");
        foreach (int id in Objects)
        {
            json.WriteNumberValue(id);
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    /// <summary>Reads an object.</summary>
    public static NuScenesEvent Read(JsonFields fields) =>
        new(fields.Text("kind"), [.. fields.Numbers("objects").Select(number => (int)number)]);
}
