using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Datasets.Files;
using Harvester.Datasets.Outputs;
using Harvester.Sessions.Text;
using Harvester.Simulation.Game;

namespace Harvester.Runs.Driving;

/// <summary>The recording of a command: a session, or a folder with a session for each game.</summary>
public sealed class DriveRecording : IDisposable
{
    private readonly RecordPlan _plan;
    private readonly List<GameRecording> _open = [];
    private readonly NumberedSessions? _numbered;
    private readonly SessionOutput? _single;
    private int _frames;
    private string? _fault;

    /// <summary>Locks and checks where the recording goes. Nothing is written before the first frame.</summary>
    /// <param name="warn">Receives warnings, one line each.</param>
    /// <param name="plan">How the drive is recorded.</param>
    /// <param name="command">The command, as its mark names it.</param>
    /// <param name="overwrite">Whether an existing session in the folder is replaced.</param>
    /// <exception cref="IOException">A file is where the folder should be.</exception>
    /// <exception cref="OccupiedFolderException">The folder has files that must not be replaced.</exception>
    public DriveRecording(Action<string> warn, RecordPlan plan, string command, bool overwrite)
    {
        _plan = plan;
        if (plan.IsNumbered)
        {
            _numbered = new NumberedSessions(warn, plan.Folder, command, overwrite);
        }
        else
        {
            _single = new SessionOutput(
                warn,
                plan.Folder,
                command,
                overwrite,
                keepsFrames: true,
                option: "--record",
                minFreeBytes: plan.MinFreeBytes
            );
        }
    }

    /// <summary>Begins the recording of a game.</summary>
    /// <param name="game">The game.</param>
    /// <param name="roads">Its roads.</param>
    /// <param name="seed">Its random seed.</param>
    /// <param name="further">Settings of this game beside those of all.</param>
    public GameRecording Of(SimulatedGame game, IRoads roads, int seed, IEnumerable<KeyValuePair<string, string>>? further = null)
    {
        var origin = new SessionOrigin
        {
            Game = "simulation",
            Tool = $"harvester {typeof(DriveRecording).Assembly.GetName().Version!.ToString(3)}",
            Seed = seed,
            Truth = LabelTruths.OfSimulation(false),
            Settings = [.. _plan.Settings, .. further ?? []],
        };
        var recording = new GameRecording(game, roads, _plan, origin, () => _single ?? _numbered!.Next(), Release);
        _open.Add(recording);
        return recording;
    }

    /// <summary>Writes what is left of all sessions.</summary>
    /// <exception cref="IOException">A session cannot be written.</exception>
    public void Close()
    {
        FinishSessions();
        if (_fault is not null)
        {
            throw new IOException(_fault);
        }
    }

    /// <summary>
    /// Completes all sessions. Call it when everything else of the command is written: until then, a recording
    /// has the mark of an unfinished one, so that the command can be given again wherever it was stopped.
    /// </summary>
    /// <returns>What was recorded, one line.</returns>
    /// <exception cref="IOException">A session cannot be written.</exception>
    public string Finish()
    {
        Close();
        if (_frames > 0)
        {
            _single?.Complete();
        }

        _numbered?.Complete();
        string sessions = _numbered is { } numbered ? $" in {Counted.Of(numbered.Count, "session")}" : "";
        string frames = Counted.Of(_frames, "frame");
        return $"recorded {frames}{sessions}  {_plan.Folder}";
    }

    /// <summary>Ends the sessions. Without <see cref="Finish"/>, they keep the mark of an unfinished recording.</summary>
    public void Dispose()
    {
        FinishSessions();
        _single?.Dispose();
        _numbered?.Dispose();
    }

    private void FinishSessions()
    {
        foreach (GameRecording recording in _open.ToArray())
        {
            recording.Dispose();
        }
    }

    /// <summary>
    /// Lets go of a recording, and with it of its game. Completes one of several sessions that is whole; a single one is complete when all
    /// of the command is.
    /// </summary>
    private void Release(GameRecording recording, SessionOutput? output, bool isWhole)
    {
        _open.Remove(recording);
        _frames += recording.Frames;
        _fault ??= recording.Fault;
        if (_numbered is null || output is null)
        {
            return;
        }

        using (output)
        {
            if (isWhole)
            {
                output.Complete();
            }
        }
    }
}
