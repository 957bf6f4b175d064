using Harvester.Sessions.Events;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading;

/// <summary>A line of events.jsonl.</summary>
/// <param name="Number">Its number in the file, from 1.</param>
/// <param name="Text">Its text.</param>
/// <param name="Event">The event; null if the line is invalid.</param>
/// <param name="Problem">Why the line is invalid; null if it is valid.</param>
public sealed record EventLine(int Number, string Text, DrivingEvent? Event, string? Problem)
{
    internal static EventLine Of(int number, string text)
    {
        try
        {
            return new EventLine(number, text, EventParser.Parse(text), null);
        }
        catch (DatasetFormatException e)
        {
            return new EventLine(number, text, null, e.Message);
        }
    }
}
