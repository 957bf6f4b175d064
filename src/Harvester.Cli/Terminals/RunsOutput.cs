using Harvester.Datasets.Files;
using Harvester.Datasets.Outputs;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Terminals;

/// <summary>
/// The folder of a command that makes a folder of its own for each of several runs, and then a file that describes them: new, empty, or
/// what the same command left unfinished.
/// </summary>
internal sealed class RunsOutput : IDisposable
{
    private readonly string _folder;
    private readonly string _command;
    private readonly string _description;
    private readonly FolderLock _held;

    /// <summary>Locks the folder and checks it.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="command">The command, as its mark names it.</param>
    /// <param name="description">Name of the file that is written last, which describes the runs.</param>
    /// <exception cref="IOException">A file is where the folder should be.</exception>
    /// <exception cref="OccupiedFolderException">The folder is in use or has other files.</exception>
    public RunsOutput(string folder, string command, string description)
    {
        (_folder, _command, _description) = (folder, command, description);
        _held = FolderLock.Take(folder);
        try
        {
            Continues = Check();
        }
        catch
        {
            _held.Dispose();
            throw;
        }
    }

    /// <summary>Whether the same command was stopped here: runs that it has finished stay, and the others continue.</summary>
    public bool Continues { get; }

    /// <summary>Makes the folder.</summary>
    /// <exception cref="IOException">The folder cannot be made.</exception>
    public void Begin()
    {
        Directory.CreateDirectory(_folder);
        if (!Continues)
        {
            UnfinishedMark.Write(_folder, _command);
        }
    }

    /// <summary>Writes the description, which makes the folder complete.</summary>
    /// <param name="write">Writes the file, at the path that it is given, whole or not at all.</param>
    public void Complete(Action<string> write)
    {
        write(Path.Combine(_folder, _description));
        UnfinishedMark.Delete(_folder);
    }

    /// <summary>Releases the folder.</summary>
    public void Dispose() => _held.Dispose();

    private bool IsComplete => File.Exists(Path.Combine(_folder, _description));

    private bool Check()
    {
        OutputDisk.Check(_folder, "--out");
        if (!Directory.Exists(_folder) || UnfinishedMark.IsAllOf(_folder))
        {
            return false;
        }

        DeleteLeftovers();
        if (UnfinishedMark.CommandIn(_folder) is { } unfinished)
        {
            return unfinished == _command
                ? true
                : throw new OccupiedFolderException(
                    $"'{_folder}' has what '{unfinished}' left unfinished. Give that command again, or name another folder with --out."
                );
        }

        throw new OccupiedFolderException(
            IsComplete
                ? $"'{_folder}' already has {_description}. Name another folder with --out."
                : $"'{_folder}' is not empty. Name another folder with --out."
        );
    }

    /// <summary>Deletes what a stopped command left of the description and of the locks of the runs.</summary>
    private void DeleteLeftovers()
    {
        if (!UnfinishedMark.IsIn(_folder) && !IsComplete)
        {
            return;
        }

        AtomicFile.DeleteLeftovers(_folder, name => name == _description);
        foreach (string run in Directory.GetDirectories(_folder))
        {
            FolderLock.Take(run).Dispose();
        }
    }
}
