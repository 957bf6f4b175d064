using Harvester.Datasets.Files;
using Harvester.Datasets.Outputs;
using Harvester.Exports.Pairs;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Terminals;

/// <summary>The folder to which counterfactuals are harvested: new, empty, or what the same command left unfinished.</summary>
internal sealed class CounterfactualOutput : IDisposable
{
    private readonly string _folder;
    private readonly string _command;
    private readonly FolderLock _held;

    /// <summary>Locks the folder and checks it.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="command">The command, as its mark names it.</param>
    /// <exception cref="IOException">A file is where the folder should be.</exception>
    /// <exception cref="OccupiedFolderException">The folder is in use or has other files.</exception>
    public CounterfactualOutput(string folder, string command)
    {
        (_folder, _command) = (folder, command);
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

    /// <summary>Whether the same command was stopped here: sessions that it has finished stay, and the others continue.</summary>
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

    /// <summary>Writes the description, which makes the set complete.</summary>
    public void Complete(ChangeSet set)
    {
        set.Write(_folder);
        UnfinishedMark.Delete(_folder);
    }

    /// <summary>Releases the folder.</summary>
    public void Dispose() => _held.Dispose();

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
            ChangeSet.IsIn(_folder)
                ? $"'{_folder}' already has counterfactuals. Name another folder with --out."
                : $"'{_folder}' is not empty. Name another folder with --out."
        );
    }

    /// <summary>Deletes what a stopped command left of the description and of the locks of the sessions.</summary>
    private void DeleteLeftovers()
    {
        if (!UnfinishedMark.IsIn(_folder) && !ChangeSet.IsIn(_folder))
        {
            return;
        }

        AtomicFile.DeleteLeftovers(_folder, name => name == ChangeSet.FileName);
        foreach (string session in Directory.GetDirectories(_folder))
        {
            FolderLock.Take(session).Dispose();
        }
    }
}
