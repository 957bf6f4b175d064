using System.Globalization;
using System.Text.Json;
using Harvester.Sessions.Events;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Sessions;

/// <summary>The table of a session's events in the data of a report.</summary>
internal static class ReportEvents
{
    /// <summary>Maximum number of events in the table.</summary>
    public const int MaxRows = 500;

    /// <summary>
    /// Writes the table as a field of the current object: for each event, by its beginning, the place of the first frame of the page that
    /// was taken during it, or null, and the texts of its cells. Events past the maximum are counted only.
    /// </summary>
    /// <param name="json">Receives it.</param>
    /// <param name="events">The events of the session, in any order.</param>
    /// <param name="frames">The frames that the page shows.</param>
    public static void Write(Utf8JsonWriter json, IEnumerable<DrivingEvent> events, IReadOnlyList<FrameLabel> frames)
    {
        DrivingEvent[] all = [.. events.OrderBy(each => each.Id)];
        json.WriteNumber("eventCount", all.Length);
        json.WriteStartArray("eventRows");
        foreach (DrivingEvent each in all.Take(MaxRows))
        {
            json.WriteStartArray();
            if (PlaceOf(each, frames) is { } place)
            {
                json.WriteNumberValue(place);
            }
            else
            {
                json.WriteNullValue();
            }

            foreach (string cell in CellsOf(each))
            {
                json.WriteStringValue(cell);
            }

            json.WriteEndArray();
        }

        json.WriteEndArray();
    }

    private static int? PlaceOf(DrivingEvent each, IReadOnlyList<FrameLabel> frames)
    {
        for (int i = 0; i < frames.Count; i++)
        {
            if (frames[i].Frame >= each.FirstFrame && frames[i].Frame <= each.LastFrame)
            {
                return i;
            }
        }

        return null;
    }

    private static IEnumerable<string> CellsOf(DrivingEvent each)
    {
        yield return Text($"{each.Id}");
        yield return JsonName.Of(each.Kind);
        yield return Text($"{each.BeginSeconds:0.00} s");
        yield return Text($"{each.EndSeconds - each.BeginSeconds:0.00} s");
        yield return string.Join(", ", each.Participants.Select(NameOf));
        yield return string.Join(", ", MeasuresOf(each));
        yield return JsonName.Of(each.End);
    }

    private static string NameOf(EventParticipant participant) =>
        participant.Object is { } number ? Text($"{JsonName.Of(participant.Class!.Value)} {number} ({participant.Model})") : "ego";

    private static IEnumerable<string> MeasuresOf(DrivingEvent each)
    {
        foreach ((string name, double? value) in each.Measures)
        {
            if (value is { } known)
            {
                yield return Text($"{name} {known:0.00}");
            }
        }

        if (each.Contact is { } contact)
        {
            yield return Text($"relativeSpeed {contact.RelativeSpeed:0.00}");
            yield return Text($"impulse {contact.Impulse:0}");
        }
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
