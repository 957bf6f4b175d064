using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Files;

/// <summary>
/// The lock of a command for its output: a <see cref="WriterLock"/>. Taking it deletes what stopped commands left beside the output.
/// </summary>
public sealed class FolderLock : IDisposable
{
    private readonly WriterLock _held;

    private FolderLock(WriterLock held) => _held = held;

    /// <summary>Locks a folder or file, which need not exist, and deletes what stopped commands left beside it.</summary>
    /// <param name="folder">The folder or file to write.</param>
    /// <param name="part">The part to write, if several processes may write one part each; empty for the whole.</param>
    /// <exception cref="OccupiedFolderException">Another process is writing to it.</exception>
    public static FolderLock Take(string folder, string part = "")
    {
        string full = FullPathOf(folder);
        WriterLock held;
        try
        {
            held = WriterLock.Take(full, part);
        }
        catch (FolderLockedException e)
        {
            throw new OccupiedFolderException(e.Message);
        }

        if (held.IsHeld)
        {
            string name = Path.GetFileName(full);
            Quietly(() =>
                AtomicFile.DeleteLeftovers(
                    Path.GetDirectoryName(full) ?? full,
                    target => WriterLock.IsOf(target, name + part) || (part.Length == 0 && target == name)
                )
            );
            if (part.Length == 0)
            {
                Quietly(() => FolderReplacement.Recover(full));
            }
        }

        return new FolderLock(held);
    }

    /// <summary>Releases the folder.</summary>
    public void Dispose() => _held.Dispose();

    /// <summary>Where a folder or file is, with the links to a folder resolved: it has one lock by all its names.</summary>
    internal static string FullPathOf(string folder) =>
        Path.TrimEndingDirectorySeparator(Directory.Exists(folder) ? InnerPath.Resolve(folder) : Path.GetFullPath(folder));

    /// <summary>Whether a name is that of the lock of a file beside it, or of the text that says who holds it.</summary>
    internal static bool IsOf(string name, string file) => WriterLock.IsOf(name, file);

    /// <summary>Runs a clean-up whose failure does not matter: the next lock tries again.</summary>
    private static void Quietly(Action action)
    {
        try
        {
            action();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return;
        }
    }
}
