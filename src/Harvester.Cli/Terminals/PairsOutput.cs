using Harvester.Datasets.Files;
using Harvester.Datasets.Outputs;
using Harvester.Exports.Pairs;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Terminals;

/// <summary>The folder to which pairs are exported: new, empty, or what the same command left unfinished.</summary>
internal sealed class PairsOutput : IDisposable
{
    private readonly string _folder;
    private readonly string _command;
    private readonly FolderLock _held;
    private readonly bool _resumes;
    private bool _isBegun;
    private bool _isKept;
    private bool _isComplete;

    /// <summary>Locks the folder and checks it.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="command">The command, as its mark names it.</param>
    /// <param name="resumes">Whether what the same command has written may stay.</param>
    /// <exception cref="IOException">A file is where the folder should be.</exception>
    /// <exception cref="OccupiedFolderException">The folder is in use or has other files.</exception>
    public PairsOutput(string folder, string command, bool resumes)
    {
        (_folder, _command, _resumes) = (folder, command, resumes);
        _held = FolderLock.Take(folder);
        try
        {
            Check();
        }
        catch
        {
            _held.Dispose();
            throw;
        }
    }

    /// <summary>Makes the folder, and empties it except for its mark and what may stay.</summary>
    /// <exception cref="IOException">The folder cannot be made or cleared.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder may not be made or cleared.</exception>
    public void Begin()
    {
        Directory.CreateDirectory(_folder);
        _isBegun = true;
        if (UnfinishedMark.CommandIn(_folder) is null)
        {
            UnfinishedMark.Write(_folder, _command);
        }

        if (_resumes)
        {
            PairExporter.ClearTables(_folder);
        }
        else
        {
            PairExporter.Clear(_folder);
        }
    }

    /// <summary>Leaves what is written, for the same command with --resume.</summary>
    public void Keep() => _isKept = true;

    /// <summary>Makes the export complete.</summary>
    public void Complete()
    {
        UnfinishedMark.Delete(_folder);
        _isComplete = true;
    }

    /// <summary>Deletes an unfinished export unless it is kept, and releases the folder.</summary>
    public void Dispose()
    {
        if (_isBegun && !_isComplete && !_isKept)
        {
            Discard();
        }

        _held.Dispose();
    }

    private void Check()
    {
        OutputDisk.Check(_folder, "--out");

        if (!Directory.Exists(_folder) || UnfinishedMark.IsAllOf(_folder))
        {
            return;
        }

        string? unfinished = UnfinishedMark.CommandIn(_folder);
        if (unfinished is null && PairExporter.IsFinished(_folder))
        {
            throw new OccupiedFolderException($"'{_folder}' already has a finished export. Name another folder with --out.");
        }

        if (unfinished != _command)
        {
            throw new OccupiedFolderException($"'{_folder}' is not empty. Name another folder with --out.");
        }

        if (PairExporter.ForeignIn(_folder) is { } other)
        {
            throw new OccupiedFolderException(
                $"'{_folder}' has other files besides an export, e.g. '{other}'. Name another folder with --out."
            );
        }
    }

    private void Discard()
    {
        try
        {
            PairExporter.Clear(_folder);
            UnfinishedMark.Delete(_folder);
            Directory.Delete(_folder);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The same command clears it when it is given again; a folder with something else stays.
            return;
        }
    }
}
