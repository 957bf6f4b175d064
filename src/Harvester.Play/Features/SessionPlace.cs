using System.Globalization;
using Harvester.Capture.Storage;
using Harvester.Sessions.Files;

namespace Harvester.Play.Features;

/// <summary>Where a session of the player goes.</summary>
internal static class SessionPlace
{
    /// <summary>A folder that does not exist yet, named by kind, date and time.</summary>
    /// <param name="folder">The folder of the sessions.</param>
    /// <param name="kind">The first word of its name.</param>
    public static string NewIn(string folder, string kind)
    {
        string name = Path.Combine(folder, kind + DateTime.Now.ToString("-yyyyMMdd-HHmmss", CultureInfo.InvariantCulture));
        string free = name;
        for (int number = 2; Directory.Exists(free); number++)
        {
            free = FormattableString.Invariant($"{name}-{number}");
        }

        return free;
    }

    /// <summary>Opens a session in a folder that no other process may write until the session is closed.</summary>
    public static SessionWriter Locked(string folder, SessionOrigin origin, int viewsPerMoment = 1, bool resume = false)
    {
        bool isNew = !Directory.Exists(folder);
        WriterLock held = WriterLock.Take(folder);
        try
        {
            return new SessionWriter(folder, origin, resume, viewsPerMoment) { Lock = held, RemovesFailedStart = isNew };
        }
        catch
        {
            held.Dispose();
            throw;
        }
    }
}
