using Harvester.Play.Screen;
using Harvester.Play.Tapes;

namespace Harvester.Play.Features;

/// <summary>The first messages of the mod, in its first tick: the head of the log, and the problems of the files beside the mod.</summary>
/// <param name="versions">The mod, the API and the game with their versions.</param>
/// <param name="folder">The files beside the mod.</param>
/// <param name="window">The game's window; null if it is unknown.</param>
/// <param name="tape">The tape that is recorded; null for none.</param>
/// <param name="messages">Shows and logs.</param>
public sealed class Greeting(string versions, ModFolder folder, IGameWindow? window, TapeRecorder? tape, PlayerMessages messages)
{
    private bool _isDone;

    /// <summary>Greets once.</summary>
    /// <param name="features">Reports a log header that cannot be made.</param>
    public void Tick(FeatureSet features)
    {
        if (_isDone)
        {
            return;
        }

        _isDone = true;
        features.Try("The mod", LogHeaderLines);
        foreach (string complaint in folder.RigProblem is { } problem ? folder.Complaints.Append(problem) : folder.Complaints)
        {
            messages.Tell(complaint);
        }

        if (tape is { IsOn: true })
        {
            messages.Tell(tape.Greeting);
        }
    }

    private void LogHeaderLines()
    {
        foreach (string line in LogHeader.Lines(versions, window, folder.Settings.Changes))
        {
            messages.Log(line);
            if (line.StartsWith(LogHeader.Window, StringComparison.Ordinal) && line.Contains(WindowDescription.Hdr))
            {
                messages.Tell("HDR is on in Windows: pictures may be overexposed. Switch it off, or check the colours by the self-test.");
            }
        }
    }
}
