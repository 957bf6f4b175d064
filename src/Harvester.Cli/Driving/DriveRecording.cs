using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Sessions.Text;
using Harvester.Simulation.Game;

namespace Harvester.Cli.Driving;

/// <summary>The recording of a command: a session, or a folder with a session for each game.</summary>
internal sealed class DriveRecording : IDisposable
{
    private readonly Terminal _terminal;
    private readonly RecordPlan _plan;
    private readonly string _command;
    private readonly bool _overwrites;
    private readonly List<GameRecording> _recordings = [];
    private int _sessions;

    /// <summary>Checks where the recording goes. Nothing is written before the first frame.</summary>
    /// <param name="terminal">Where warnings go.</param>
    /// <param name="plan">How the drive is recorded.</param>
    /// <param name="command">The command, as <see cref="CommandText"/> gives it.</param>
    /// <param name="overwrite">Whether an existing session in the folder is replaced.</param>
    /// <exception cref="IOException">A file is where the folder should be.</exception>
    /// <exception cref="OccupiedFolderException">The folder has files that must not be replaced.</exception>
    public DriveRecording(Terminal terminal, RecordPlan plan, string command, bool overwrite)
    {
        (_terminal, _plan, _command, _overwrites) = (terminal, plan, command, overwrite);
        if (plan.IsNumbered)
        {
            if (OutputFolder.FileInTheWayOf(plan.Folder) is { } file)
            {
                throw new IOException($"'{file}' is a file. Name a folder with --record.");
            }

            if (Directory.Exists(plan.Folder) && Directory.EnumerateFileSystemEntries(plan.Folder).Any())
            {
                throw new OccupiedFolderException(
                    $"'{plan.Folder}' is not empty; it is to get a session for each drive. Name another folder with --record.");
            }
        }
        else
        {
            OutputFolder.Check(plan.Folder, command, overwrite);
        }
    }

    /// <summary>Begins the recording of a game.</summary>
    /// <param name="game">The game.</param>
    /// <param name="roads">Its roads.</param>
    /// <param name="seed">Its random seed.</param>
    public GameRecording Of(SimulatedGame game, IRoads roads, int seed)
    {
        var origin = new SessionOrigin
        {
            Game = "simulation",
            Tool = $"harvester {typeof(DriveRecording).Assembly.GetName().Version!.ToString(3)}",
            Seed = seed,
            Truth = LabelTruths.OfSimulation(false),
            Settings = _plan.Settings,
        };
        var recording = new GameRecording(game, roads, _plan, origin, NewOutput);
        _recordings.Add(recording);
        return recording;
    }

    /// <summary>Finishes all sessions, and says what was recorded.</summary>
    /// <exception cref="IOException">A session cannot be written.</exception>
    public void Finish()
    {
        Dispose();
        if (_recordings.Select(recording => recording.Fault).FirstOrDefault(fault => fault is not null) is { } fault)
        {
            throw new IOException(fault);
        }

        string sessions = _plan.IsNumbered ? $" in {Counted.Of(_sessions, "session")}" : "";
        string frames = Counted.Of(_recordings.Sum(recording => recording.Frames), "frame");
        _terminal.Out.WriteLine($"recorded {frames}{sessions}  {_plan.Folder}");
    }

    /// <summary>Finishes all sessions.</summary>
    public void Dispose()
    {
        foreach (GameRecording recording in _recordings)
        {
            recording.Dispose();
        }
    }

    private SessionOutput NewOutput()
    {
        _sessions++;
        string folder = _plan.IsNumbered
            ? Path.Combine(_plan.Folder, _sessions.ToString("D4", CultureInfo.InvariantCulture))
            : _plan.Folder;
        return new SessionOutput(_terminal, folder, _command, _overwrites, keepsFrames: true);
    }
}
