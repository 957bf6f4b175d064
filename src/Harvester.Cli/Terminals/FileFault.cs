using System;
using System.IO;
using System.Linq;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Terminals;

/// <summary>
/// What went wrong with a file, for people: what, where, what to do. The runtime has sentences of its own for that, in English in every
/// culture, and names a path nowhere but in them; what the project says itself is left as it is.
/// </summary>
internal static class FileFault
{
    // A full disk and a used up quota on Linux, macOS and Windows.
    private static readonly int[] FullDisk = [28, 122, 69, unchecked((int)0x80070070), unchecked((int)0x80070027)];

    private static readonly string[] SentencesOfRuntime = ["Could not find a part of the path '", "Access to the path '", "Is a directory : '", "Cannot create '", "The file '"];

    /// <summary>One line.</summary>
    /// <param name="fault">What was thrown.</param>
    /// <param name="output">Where the command writes to, for faults that do not name their file; null if nobody has said that.</param>
    public static string TextOf(Exception fault, string? output)
    {
        string message = fault.Message;
        if (FullDisk.Contains(fault.HResult))
        {
            string where = (QuotedIn(message) ?? output) is { } full ? $": '{full}' cannot be written" : "";
            return $"The disk is full{where}. Free some space, or name a place on another disk, and give the command again.";
        }

        if (fault is FileNotFoundException { FileName: { } name })
        {
            return $"There is no file '{name}'. Name one that is there.";
        }

        return SentencesOfRuntime.Any(sentence => message.StartsWith(sentence, StringComparison.Ordinal)) && QuotedIn(message) is { } path
            ? TextOf(path, fault)
            : message;
    }

    private static string TextOf(string path, Exception fault) =>
        Directory.Exists(path) ? FolderText(path, fault)
        : fault is UnauthorizedAccessException ? $"'{path}' may not be read or written. Ask for the right to, or name another."
        : OutputFolder.FileInTheWayOf(path) is { } file ? $"'{file}' is a file. Name a folder."
        : $"There is no folder '{Path.GetDirectoryName(path)}'. Name one that is there.";

    // Where a file should be, the runtime refuses access to a folder just as it does without the right to it.
    private static string FolderText(string path, Exception fault) =>
        fault is UnauthorizedAccessException ? $"'{path}' is a folder that may not be read or written, or stands where a file should be. Name another."
        : $"'{path}' is a folder. Name a file.";

    /// <summary>The path in a message, which may have apostrophes itself.</summary>
    private static string? QuotedIn(string message)
    {
        int start = message.IndexOf('\'', StringComparison.Ordinal) + 1;
        int end = message.LastIndexOf('\'');
        string? path = end > start ? message[start..end] : null;
        return path is null ? null : AtomicFile.TargetOf(path) ?? path;
    }
}
