using Harvester.Datasets.Outputs;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Terminals;

/// <summary>
/// Makes messages of file system errors: what, where, what to do. The kind of error comes from the exception's type and result code. The
/// path comes from the quotation marks in the runtime's message, because no property has it. Messages of this project are kept.
/// </summary>
internal static class FileFault
{
    // Disk full or quota exceeded: ENOSPC, EDQUOT on Linux and on macOS, ERROR_DISK_FULL, ERROR_HANDLE_DISK_FULL.
    private static readonly int[] FullDisk = [28, 122, 69, unchecked((int)0x80070070), unchecked((int)0x80070027)];

    private static readonly string? Runtime = typeof(File).Assembly.GetName().Name;

    /// <summary>
    /// Whether the runtime could not allocate the space of a file of known size: its exception has no code of the system.
    /// </summary>
    private static bool IsUnallocated(Exception fault) =>
        fault is IOException && fault.Source == Runtime && fault.Message.EndsWith("because the disk was full.", StringComparison.Ordinal);

    /// <summary>The message, one line.</summary>
    /// <param name="fault">The exception.</param>
    /// <param name="output">The command's output, named if the exception does not name a file; null if unknown.</param>
    public static string TextOf(Exception fault, string? output)
    {
        if (FullDisk.Contains(fault.HResult) || IsUnallocated(fault))
        {
            string where = (QuotedIn(fault.Message) ?? output) is { } full ? $": '{full}' cannot be written" : "";
            return $"The disk is full{where}. Free some space, or write to another disk, and run the command again.";
        }

        if (fault is FileNotFoundException { FileName: { } name })
        {
            return $"File not found: '{name}'.";
        }

        return fault.Source == Runtime && QuotedIn(fault.Message) is { } path ? TextOf(path, fault) : fault.Message;
    }

    private static string TextOf(string path, Exception fault) =>
        Directory.Exists(path) ? FolderText(path, fault)
        : fault is UnauthorizedAccessException ? $"Permission denied: '{path}'. Change its permissions, or name another path."
        : OutputFolder.FileInTheWayOf(path) is { } file ? $"'{file}' is a file. Name a folder."
        : fault is DirectoryNotFoundException ? $"Folder not found: '{Path.GetDirectoryName(path)}'."
        : fault.Message;

    // The runtime throws the same exception for a folder without permission and for a folder where a file is expected.
    private static string FolderText(string path, Exception fault) =>
        fault is UnauthorizedAccessException
            ? $"'{path}' is a folder where a file is expected, or access to it is denied. Name another path."
            : $"'{path}' is a folder. Name a file.";

    /// <summary>The path in a message; it may contain apostrophes itself.</summary>
    private static string? QuotedIn(string message)
    {
        int start = message.IndexOf('\'', StringComparison.Ordinal) + 1;
        int end = message.LastIndexOf('\'');
        string? path = end > start ? message[start..end] : null;
        return path is null ? null : AtomicFile.TargetOf(path) ?? path;
    }
}
