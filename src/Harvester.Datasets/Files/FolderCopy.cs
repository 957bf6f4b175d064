using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Files;

/// <summary>Takes the files of a folder into another one that is to replace it.</summary>
internal static class FolderCopy
{
    /// <summary>
    /// Adds to a folder all that it does not have of another: files as second names of the same file where the file system can do that,
    /// links as they are. Temporary files are left out.
    /// </summary>
    /// <exception cref="DatasetFormatException">The folder holds a pipe, a socket or a device.</exception>
    /// <exception cref="IOException">Something cannot be copied.</exception>
    /// <exception cref="UnauthorizedAccessException">Something may not be copied.</exception>
    public static void AddMissing(string from, string to)
    {
        foreach (string source in Directory.EnumerateFileSystemEntries(from))
        {
            string target = Path.Combine(to, Path.GetFileName(source));
            if (new FileInfo(source).LinkTarget is { } link)
            {
                if (!Path.Exists(target))
                {
                    File.CreateSymbolicLink(target, link);
                }
            }
            else if (Directory.Exists(source))
            {
                AddFolder(source, target);
            }
            else if (AtomicFile.TargetOf(source) is null && !File.Exists(target))
            {
                AddFile(source, target);
            }
        }
    }

    private static void AddFolder(string source, string target)
    {
        Directory.CreateDirectory(target);
        AddMissing(source, target);
        if (!OperatingSystem.IsWindows())
        {
            File.SetUnixFileMode(target, File.GetUnixFileMode(source));
        }
    }

    private static void AddFile(string source, string target) =>
        FileTransfer.Place(
            target,
            RegularFile.IsSpecial(source) ? throw new DatasetFormatException($"'{source}' is a pipe, a socket or a device.") : source,
            ImageTransfer.Link
        );
}
