using System;
using System.IO;
using System.Text;
using System.Text.RegularExpressions;

namespace Harvester.Sessions.Files;

/// <summary>
/// Files that appear whole or not at all. Each is written to a temporary file in the folder of its target and then renamed. The temporary
/// file is created exclusively and its name cannot be predicted, so that a link planted in the folder is never followed.
/// </summary>
public static class AtomicFile
{
    private const string Suffix = ".partial";
    private static readonly Regex TemporaryName = new(
        @"\A(.+)\.[0-9a-f]{16}\.partial\z", RegexOptions.CultureInvariant | RegexOptions.Singleline);

    /// <summary>Writes a file, in place of an older one.</summary>
    /// <param name="path">The file; its folder must exist.</param>
    /// <param name="content">Writes the content to a stream and leaves the stream open.</param>
    /// <param name="isDurable">Whether the file must survive a loss of power once this returns; this waits for the disk.</param>
    /// <exception cref="IOException">The file cannot be written or closed; an older one is unchanged.</exception>
    /// <exception cref="UnauthorizedAccessException">The file may not be written; an older one is unchanged.</exception>
    public static void Write(string path, Action<Stream> content, bool isDurable = false)
    {
        Make(path, temporary => Fill(temporary, content, isDurable));
        if (isDurable)
        {
            DiskSync.Folder(FolderOf(path));
        }
    }

    /// <summary>Writes a text file in UTF-8 without a byte order mark, in place of an older one.</summary>
    /// <param name="path">The file; its folder must exist.</param>
    /// <param name="text">The text; its line ends are kept.</param>
    /// <exception cref="IOException">The file cannot be written or closed; an older one is unchanged.</exception>
    /// <exception cref="UnauthorizedAccessException">The file may not be written; an older one is unchanged.</exception>
    public static void Write(string path, string text) => Write(path, stream => WriteText(stream, text));

    /// <summary>Writes a text file unless there is one already.</summary>
    /// <param name="path">The file; its folder must exist.</param>
    /// <param name="text">The text; its line ends are kept.</param>
    /// <returns>Whether it was written. Of several that write at once, one succeeds.</returns>
    /// <exception cref="IOException">The file cannot be written or closed.</exception>
    /// <exception cref="UnauthorizedAccessException">The file may not be written.</exception>
    public static bool TryWriteNew(string path, string text)
    {
        string temporary = TemporaryFor(path);
        try
        {
            Fill(temporary, stream => WriteText(stream, text), isDurable: false);
            File.Move(temporary, path);
            return true;
        }
        catch (IOException) when (File.Exists(path))
        {
            return false;
        }
        finally
        {
            DeleteQuietly(temporary);
        }
    }

    /// <summary>Puts a file that is made by other means, such as a copy, in the place of an older one.</summary>
    /// <param name="path">The file; its folder must exist.</param>
    /// <param name="make">Makes the file under the name that it is given, at which there is none.</param>
    /// <exception cref="IOException">The file cannot be put in its place; an older one is unchanged.</exception>
    /// <exception cref="UnauthorizedAccessException">The file may not be written; an older one is unchanged.</exception>
    public static void Make(string path, Action<string> make)
    {
        string temporary = TemporaryFor(path);
        try
        {
            make(temporary);
            Replace(temporary, path);
        }
        finally
        {
            // There still is one after a failure, and where both were names of one file: to rename does nothing then.
            DeleteQuietly(temporary);
        }
    }

    /// <summary>A name for a temporary file or folder beside a target, known to nobody else.</summary>
    public static string TemporaryFor(string path) => $"{path}.{Guid.NewGuid().ToString("N").Substring(0, 16)}{Suffix}";

    /// <summary>The file for which a temporary file was made, by their names; null for the name of another file.</summary>
    public static string? TargetOf(string temporary) =>
        TemporaryName.Match(temporary) is { Success: true } match ? match.Groups[1].Value : null;

    /// <summary>Deletes the temporary files that writers left in a folder when they were stopped. What cannot be deleted stays.</summary>
    /// <param name="folder">The folder; those in it are not searched. It need not exist.</param>
    /// <param name="isTarget">Says by its name whether a file is the caller's to write; a temporary file of another stays.</param>
    /// <exception cref="IOException">The folder cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder may not be read.</exception>
    public static void DeleteLeftovers(string folder, Predicate<string> isTarget)
    {
        foreach (string path in Directory.Exists(folder) ? Directory.GetFiles(folder, "*" + Suffix) : [])
        {
            if (TargetOf(Path.GetFileName(path)) is { } target && isTarget(target))
            {
                DeleteQuietly(path);
            }
        }
    }

    internal static void Fill(string temporary, Action<Stream> content, bool isDurable)
    {
        using var stream = new FileStream(temporary, FileMode.CreateNew, FileAccess.Write, FileShare.None);
        content(stream);
        stream.Flush(isDurable);
        DiskSync.CheckClose(stream.SafeFileHandle);
    }

    private static void WriteText(Stream stream, string text)
    {
        byte[] bytes = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false).GetBytes(text);
        stream.Write(bytes, 0, bytes.Length);
    }

    private static void Replace(string temporary, string path)
    {
#if NET
        File.Move(temporary, path, overwrite: true);
#else
        if (File.Exists(path))
        {
            File.Replace(temporary, path, null);
        }
        else
        {
            File.Move(temporary, path);
        }
#endif
    }

    private static string FolderOf(string path) => Path.GetDirectoryName(Path.GetFullPath(path))!;

    private static void DeleteQuietly(string temporary)
    {
        try
        {
            File.Delete(temporary);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            // The failure that led here is the one to report; readers skip temporary names.
        }
    }
}
