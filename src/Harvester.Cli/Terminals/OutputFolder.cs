using System.IO;
using System.Linq;
using Harvester.Datasets.Files;
using Harvester.Datasets.Reports;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Terminals;

/// <summary>Makes room for a new session. Nothing but an earlier session is ever deleted, and only when that was asked for.</summary>
internal static class OutputFolder
{
    private static readonly string[] Files = [SessionInfo.FileName, SessionReader.LabelsFile, ReportWriter.FileName];
    private static readonly string[] Folders = [FramePaths.Frames, FramePaths.Masks, FramePaths.Scenes];

    /// <summary>Checks that a session may be written to a folder, and changes nothing.</summary>
    /// <exception cref="IOException">A file is where the folder should be.</exception>
    /// <exception cref="OccupiedFolderException">The folder holds something that is not to be replaced.</exception>
    public static void Check(string folder, bool overwrite)
    {
        if (FileInTheWayOf(folder) is { } file)
        {
            throw new IOException($"'{file}' is a file. Name a folder with --out.");
        }

        if (HoldsNoFile(folder))
        {
            return;
        }

        if (!File.Exists(Path.Combine(folder, SessionInfo.FileName)))
        {
            throw new OccupiedFolderException($"'{folder}' is not empty and holds no session. Name another folder with --out.");
        }

        if (!overwrite)
        {
            throw new OccupiedFolderException($"'{folder}' already holds a session. Name another folder with --out, or replace it with --overwrite.");
        }

        if (Directory.EnumerateFileSystemEntries(folder).Select(Path.GetFileName).Except([.. Files, .. Folders])
            .FirstOrDefault() is { } other)
        {
            throw new OccupiedFolderException($"'{folder}' holds other files besides a session, e.g. '{other}'. Name another folder with --out.");
        }
    }

    /// <summary>A file that stands where the folder or one that holds it should be; null when there is none.</summary>
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

    /// <summary>Deletes the session in a folder that has passed the check, or the empty folders of one.</summary>
    public static void Clear(string folder)
    {
        if (!Directory.Exists(folder))
        {
            return;
        }

        foreach (string file in Files)
        {
            File.Delete(Path.Combine(folder, file));
        }

        foreach (string path in Folders.Select(name => Path.Combine(folder, name)).Where(Directory.Exists))
        {
            Directory.Delete(path, recursive: true);
        }
    }

    /// <summary>
    /// Deletes what a harvest left that ended before its session was opened, and the folder with it, unless it holds something else.
    /// </summary>
    public static void DiscardUnopened(string folder)
    {
        if (Directory.Exists(folder) && !File.Exists(Path.Combine(folder, SessionInfo.FileName)))
        {
            Clear(folder);
            if (!Directory.EnumerateFileSystemEntries(folder).Any())
            {
                Directory.Delete(folder);
            }
        }
    }

    /// <summary>Whether there is no folder or nothing but folders in it, as a harvest leaves them that found the disk full.</summary>
    private static bool HoldsNoFile(string folder) =>
        !Directory.Exists(folder) || !Directory.EnumerateFiles(folder, "*", SearchOption.AllDirectories).Any();
}
