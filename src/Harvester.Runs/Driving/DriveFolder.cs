using Harvester.Datasets.Files;
using Harvester.Datasets.Outputs;
using Harvester.Runs.Evaluation.Reports;
using Harvester.Runs.Evaluation.Scores;
using Harvester.Sessions.Files;

namespace Harvester.Runs.Driving;

/// <summary>The output folder of a drive. Only an existing drive is ever replaced, and only with --overwrite.</summary>
public sealed class DriveFolder
{
    private static readonly string[] Files = [DriveRecord.FileName, DriveReport.FileName];

    private readonly string _folder;
    private readonly string _command;

    /// <summary>Checks that a drive may be written to a folder, and creates the folder.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="command">The command, as its mark names it.</param>
    /// <param name="overwrite">Whether an existing drive is replaced.</param>
    /// <param name="isRepeated">Whether the drive there is one that this command had written when it was stopped.</param>
    /// <exception cref="IOException">The folder, or one above it, is a file.</exception>
    /// <exception cref="OccupiedFolderException">The folder has files that must not be replaced.</exception>
    public DriveFolder(string folder, string command, bool overwrite, bool isRepeated)
    {
        _folder = folder;
        _command = command;
        OutputDisk.Check(folder, "--out");
        Directory.CreateDirectory(folder);
        string[] found = [.. Directory.EnumerateFileSystemEntries(folder).Select(entry => Path.GetFileName(entry))];
        if (found.FirstOrDefault(name => !BridgeFolder.IsDefault(name) && !IsOwn(name)) is { } other)
        {
            throw new OccupiedFolderException(
                $"'{folder}' has files that are not a drive's, e.g. '{other}'. Name another folder with --out."
            );
        }

        string? unfinished = UnfinishedMark.CommandIn(folder);
        Replaces = unfinished != command && found.Intersect(Files).Any();
        if (Replaces && !overwrite && !isRepeated)
        {
            throw new OccupiedFolderException(
                unfinished is null
                    ? $"'{folder}' already has a drive. Name another folder with --out, or replace it with --overwrite."
                    : $"'{folder}' has the unfinished result of '{OutputFolder.Shown(unfinished)}'. Run that command again, "
                        + "name another folder with --out, or replace it with --overwrite."
            );
        }
    }

    /// <summary>Whether a former drive is replaced.</summary>
    public bool Replaces { get; }

    /// <summary>Writes a drive. One that is to be replaced is whole until the new one is.</summary>
    /// <param name="fill">Writes all files of the drive into the folder that it is given.</param>
    /// <returns>Where the drive that was replaced still is, if it could not be deleted; otherwise null.</returns>
    /// <exception cref="IOException">The drive cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The drive cannot be written.</exception>
    public string? Write(Action<string> fill)
    {
        if (Replaces)
        {
            return Replace(fill);
        }

        UnfinishedMark.Write(_folder, _command);
        AtomicFile.DeleteLeftovers(_folder, IsOwn);
        fill(_folder);
        UnfinishedMark.Delete(_folder);
        return null;
    }

    private static bool IsOwn(string name) => UnfinishedMark.Is(name) || Files.Contains(AtomicFile.TargetOf(name) ?? name);

    private string? Replace(Action<string> fill)
    {
        using FolderReplacement replacement = FolderReplacement.Begin(_folder);
        fill(replacement.Folder);

        // The shared folder of a bridge is no result: it goes along, for a client that looks into it.
        string bridge = Path.Combine(_folder, BridgeFolder.DefaultName);
        string moved = Path.Combine(replacement.Folder, BridgeFolder.DefaultName);
        if (!Directory.Exists(bridge))
        {
            return replacement.Complete();
        }

        Directory.Move(bridge, moved);
        try
        {
            return replacement.Complete();
        }
        catch
        {
            Directory.Move(moved, bridge);
            throw;
        }
    }
}
