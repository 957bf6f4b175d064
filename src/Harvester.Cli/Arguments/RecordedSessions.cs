using Harvester.Cli.Terminals;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Cli.Arguments;

/// <summary>Opens the sessions that a command works on.</summary>
internal static class RecordedSessions
{
    /// <summary>Opens a session. If its last line is unfinished, writes a note to standard error.</summary>
    /// <param name="terminal">Where the note goes.</param>
    /// <param name="folder">The folder of the session.</param>
    /// <param name="cancellation">Ends the reading of its labels.</param>
    /// <exception cref="System.IO.IOException">The folder is not a session, or cannot be read.</exception>
    /// <exception cref="DatasetFormatException">Its session.json is malformed.</exception>
    public static SessionReader Open(Terminal terminal, string folder, CancellationToken cancellation)
    {
        var session = new SessionReader(folder, cancellation);
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

    /// <summary>A note if the last line of a session is unfinished; otherwise null.</summary>
    public static string? NoteOf(SessionReader session) =>
        session.HasUnfinishedLine
            ? $"the unfinished last line of {SessionReader.LabelsFile} is ignored; the recording was interrupted."
            : null;
}
