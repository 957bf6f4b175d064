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
        @"\A(.+)\.[0-9a-f]{16}\.partial\z",
        RegexOptions.CultureInvariant | RegexOptions.Singleline
    );

    /// <summary>Writes a file, in place of an older one.</summary>
    /// <param name="path">The file; its folder must exist.</param>
    /// <param name="content">Writes the content to a stream and leaves the stream open.</param>
    /// <param name="isDurable">
    /// Whether file and name survive a loss of power once this returns, which waits for the disk. False for files that a
    /// <see cref="SyncBatch"/> brings there, and for those that are of use only to a running process.
    /// </param>
    /// <exception cref="IOException">The file cannot be written or closed; an older one is unchanged.</exception>
    /// <exception cref="UnauthorizedAccessException">The file cannot be written; an older one is unchanged.</exception>
    public static void Write(string path, Action<Stream> content, bool isDurable = true)
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
    /// <param name="isDurable">As for a file that is not a text.</param>
    /// <exception cref="IOException">The file cannot be written or closed; an older one is unchanged.</exception>
    /// <exception cref="UnauthorizedAccessException">The file cannot be written; an older one is unchanged.</exception>
    public static void Write(string path, string text, bool isDurable = true) => Write(path, stream => WriteText(stream, text), isDurable);

    /// <summary>Writes a text file unless there is one already.</summary>
    /// <param name="path">The file; its folder must exist.</param>
    /// <param name="text">The text; its line ends are kept.</param>
    /// <param name="isDurable">As for a file that may replace one.</param>
    /// <returns>Whether it was written. Of several that write at once, one succeeds.</returns>
    /// <exception cref="IOException">The file cannot be written or closed.</exception>
    /// <exception cref="UnauthorizedAccessException">The file cannot be written.</exception>
    public static bool TryWriteNew(string path, string text, bool isDurable = true)
    {
        string temporary = TemporaryFor(path);
        try
        {
            Fill(temporary, stream => WriteText(stream, text), isDurable);
            File.Move(temporary, path);
        }
        catch (IOException) when (File.Exists(path))
        {
            return false;
        }
        finally
        {
            DeleteQuietly(temporary);
        }

        if (isDurable)
        {
            DiskSync.Folder(FolderOf(path));
        }

        return true;
    }

    /// <summary>Replaces a file by one that is made by other means, such as a copy.</summary>
    /// <param name="path">The file; its folder must exist.</param>
    /// <param name="make">Makes the file under the name that it is given; no such file exists.</param>
    /// <exception cref="IOException">The file cannot be replaced; an older one is unchanged.</exception>
    /// <exception cref="UnauthorizedAccessException">The file may not be replaced; an older one is unchanged.</exception>
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
            // It remains after a failure, and if both names were links to one file: renaming does nothing then.
            DeleteQuietly(temporary);
        }
    }

    /// <summary>An unpredictable name for a temporary file or folder beside a target.</summary>
    public static string TemporaryFor(string path) => $"{path}.{Guid.NewGuid().ToString("N").Substring(0, 16)}{Suffix}";

    /// <summary>The target of a temporary file, from its name; null if the name is not that of a temporary file.</summary>
    public static string? TargetOf(string temporary) =>
        TemporaryName.Match(temporary) is { Success: true } match ? match.Groups[1].Value : null;

    /// <summary>Deletes the temporary files that writers left in a folder when they were stopped. What cannot be deleted stays.</summary>
    /// <param name="folder">The folder; its subfolders are not searched. It need not exist.</param>
    /// <param name="isTarget">Whether a file of this name is the caller's; temporary files of other targets stay.</param>
    /// <exception cref="IOException">The folder cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder cannot be read.</exception>
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

    /// <summary>Writes a new file under its final name, as <see cref="Make"/> needs it; a failure leaves a part of it.</summary>
    /// <param name="temporary">The file, which does not exist.</param>
    /// <param name="content">Writes the content to a stream and leaves the stream open.</param>
    /// <param name="isDurable">Whether the content is on the disk when this returns.</param>
    /// <exception cref="IOException">The file cannot be written or closed.</exception>
    /// <exception cref="UnauthorizedAccessException">The file cannot be written.</exception>
    public static void Fill(string temporary, Action<Stream> content, bool isDurable)
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
