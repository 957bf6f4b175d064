using System.IO;
using System.Linq;
using Harvester.Capture.Harvesting;
using Harvester.Datasets.Reports;
using Harvester.Datasets.Sessions;

namespace Harvester.Cli.Harvesting;

/// <summary>Makes room for a new session. Nothing but an earlier session is ever deleted, and only when that was asked for.</summary>
internal static class OutputFolder
{
    /// <summary>Leaves the folder empty or absent.</summary>
    /// <exception cref="UsageException">The folder holds something that is not to be replaced.</exception>
    public static void Prepare(string folder, bool overwrite)
    {
        if (!Directory.Exists(folder) || !Directory.EnumerateFileSystemEntries(folder).Any())
        {
            return;
        }

        if (!File.Exists(Path.Combine(folder, SessionInfo.FileName)))
        {
            throw new UsageException($"'{folder}' is not empty and holds no session. Name another folder with --out.");
        }

        if (!overwrite)
        {
            throw new UsageException($"'{folder}' holds a session already. Name another folder with --out, or replace it with --overwrite.");
        }

        DeleteSession(folder);
        if (Directory.EnumerateFileSystemEntries(folder).FirstOrDefault() is { } other)
        {
            throw new UsageException($"'{folder}' holds more than a session, '{Path.GetFileName(other)}' for one. Name another folder with --out.");
        }
    }

    private static void DeleteSession(string folder)
    {
        foreach (string file in (string[])[SessionInfo.FileName, SessionReader.LabelsFile, ReportWriter.FileName])
        {
            File.Delete(Path.Combine(folder, file));
        }

        foreach (string name in (string[])[FramePaths.Frames, FramePaths.Masks])
        {
            string path = Path.Combine(folder, name);
            if (Directory.Exists(path))
            {
                Directory.Delete(path, recursive: true);
            }
        }
    }
}
