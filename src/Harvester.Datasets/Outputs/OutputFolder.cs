using Harvester.Datasets.Derivation;
using Harvester.Datasets.Files;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;

namespace Harvester.Datasets.Outputs;

/// <summary>
/// Checks the output folder of a session. Only an unfinished result of the same command is replaced, or, with --overwrite, a session.
/// </summary>
public static class OutputFolder
{
    /// <summary>Checks that a session may be written to a folder. Changes nothing.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="command">The command that is to write it, as in its mark.</param>
    /// <param name="overwrite">Whether a session there is to be replaced; null for a command that never replaces one.</param>
    /// <param name="option">The option that names the folder.</param>
    /// <returns>Whether something is to be replaced; false if the folder is new, empty or has only what the same command left.</returns>
    /// <exception cref="IOException">The folder, or one above it, is a file.</exception>
    /// <exception cref="OccupiedFolderException">The folder has files that must not be replaced.</exception>
    public static bool Check(string folder, string command, bool? overwrite, string option = "--out")
    {
        if (FileInTheWayOf(folder) is { } file)
        {
            throw new IOException($"'{file}' is a file. Name a folder with {option}.");
        }

        if (HoldsNoFile(folder))
        {
            return false;
        }

        string? unfinished = UnfinishedMark.CommandIn(folder);
        if (unfinished != command)
        {
            RefuseOccupied(folder, unfinished, overwrite, option);
        }

        return SessionFolder.ForeignIn(folder) is { } other
            ? throw new OccupiedFolderException(
                $"'{folder}' has other files besides a session, e.g. '{other}'. Name another folder with {option}."
            )
            : unfinished != command;
    }

    /// <summary>The file in place of the folder or of one above it; null if there is none.</summary>
    public static string? FileInTheWayOf(string folder)
    {
        for (string? path = Path.GetFullPath(folder); path is not null; path = Path.GetDirectoryName(path))
        {
            if (File.Exists(path))
            {
                return path;
            }
        }

        return null;
    }

    /// <summary>The beginning of a command, for a message: the file that has it may be untrusted.</summary>
    public static string Shown(string command)
    {
        const int maxCharacters = 200;
        return command.Length > maxCharacters ? command[..maxCharacters] + "..." : command;
    }

    private static void RefuseOccupied(string folder, string? unfinished, bool? overwrite, string option)
    {
        if (unfinished is null && !File.Exists(Path.Combine(folder, SessionInfo.FileName)))
        {
            throw new OccupiedFolderException($"'{folder}' is not empty and has no session. Name another folder with {option}.");
        }

        if (overwrite != true)
        {
            string what = unfinished is null
                ? "already has a session. Name"
                : $"has the unfinished result of '{Shown(unfinished)}'. Run that command again, name";
            string replace = overwrite is null ? "delete the folder" : "replace it with --overwrite";
            throw new OccupiedFolderException($"'{folder}' {what} another folder with {option}, or {replace}.");
        }
    }

    /// <summary>Whether the folder is missing, or holds nothing but folders and an unfinished mark.</summary>
    private static bool HoldsNoFile(string folder) =>
        !Directory.Exists(folder)
        || Directory
            .EnumerateFiles(folder, "*", SearchOption.AllDirectories)
            .All(path => AtomicFile.TargetOf(Path.GetFileName(path)) == UnfinishedMark.FileName);
}
