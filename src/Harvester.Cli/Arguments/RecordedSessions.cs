using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sessions;

namespace Harvester.Cli.Arguments;

/// <summary>Opens the sessions that a command works on.</summary>
internal static class RecordedSessions
{
    /// <summary>Opens one whose session.json can be read, and says on standard error what is left aside of it.</summary>
    /// <exception cref="System.IO.IOException">It is no session, or cannot be read.</exception>
    /// <exception cref="DatasetFormatException">Its session.json is malformed.</exception>
    public static SessionReader Open(Terminal terminal, string folder)
    {
        var session = new SessionReader(folder);
        try
        {
            session.ReadInfo();
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"{folder}: {e.Message}", e);
        }

        if (NoteOf(session) is { } note)
        {
            terminal.WriteError($"{folder}: {note}");
        }

        return session;
    }

    /// <summary>What of a session is left aside; null for nothing.</summary>
    public static string? NoteOf(SessionReader session) => session.HasUnfinishedLine
        ? $"the unfinished last line of {SessionReader.LabelsFile} is ignored; the recording was interrupted."
        : null;
}
