using Harvester.Sessions.Events;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.Csv;

/// <summary>The table events.csv: a row for each event that is open at a frame.</summary>
internal static class CsvEventTable
{
    /// <summary>Name of the file.</summary>
    public const string FileName = "events.csv";

    /// <summary>Name of its part.</summary>
    public const string Part = "events";

    /// <summary>Its columns.</summary>
    public static string[] Columns { get; } = ["frame", "session", "event", "kind"];

    /// <summary>The row of an event at a frame.</summary>
    public static IEnumerable<string> Fields(ExportFrame frame, EventMark mark) =>
        [Numbers.Text(frame.Index), Numbers.Text(frame.RecordingIndex), Numbers.Text(mark.Id), JsonName.Of(mark.Kind)];
}
