using System.IO;
using System.Linq;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Evaluation.Figures;
using Harvester.Evaluation.Reports;

namespace Harvester.Cli.Driving;

/// <summary>
/// The folder that a drive is written to. Nothing but an earlier drive is ever replaced, and only when that was asked for.
/// </summary>
internal static class DriveFolder
{
    private static readonly string[] Files = [DriveRecord.FileName, DriveReport.FileName];

    /// <summary>Checks that a drive may be written to a folder, and makes it where it is not there.</summary>
    /// <exception cref="IOException">A file is where the folder should be.</exception>
    /// <exception cref="OccupiedFolderException">The folder holds something that is not to be replaced.</exception>
    public static void Prepare(string folder, bool overwrite)
    {
        if (OutputFolder.FileInTheWayOf(folder) is { } file)
        {
            throw new IOException($"'{file}' is a file. Name a folder with --out.");
        }

        Directory.CreateDirectory(folder);
        string[] found = [.. Directory.EnumerateFileSystemEntries(folder).Select(entry => Path.GetFileName(entry))];
        if (found.Except([.. Files, BridgeFolder.DefaultName]).FirstOrDefault() is { } other)
        {
            throw new OccupiedFolderException($"'{folder}' holds other files besides a drive, e.g. '{other}'. Name another folder with --out.");
        }

        if (!overwrite && found.Intersect(Files).Any())
        {
            throw new OccupiedFolderException($"'{folder}' already holds a drive. Name another folder with --out, or replace it with --overwrite.");
        }
    }
}
