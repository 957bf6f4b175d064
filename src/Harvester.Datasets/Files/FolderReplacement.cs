using Harvester.Sessions.Files;

namespace Harvester.Datasets.Files;

/// <summary>
/// Replaces a folder in one step. The new one is made beside it, in a temporary folder with a mark, and exchanged with the old one when it
/// is complete; then the old one is deleted. Where the system cannot exchange folders, two renames do it; if the command is stopped between
/// them, the next command that locks the folder undoes the first. Hold the <see cref="FolderLock"/> of the folder.
/// </summary>
public sealed class FolderReplacement : IDisposable
{
    private const string FormerSuffix = ".former";

    private readonly string _target;
    private readonly string _container;
    private readonly bool _exchanges;
    private bool _isComplete;

    private FolderReplacement(string target, bool exchanges)
    {
        _target = target;
        _container = AtomicFile.TemporaryFor(target);
        _exchanges = exchanges;
        Folder = Path.Combine(_container, Path.GetFileName(target));
    }

    /// <summary>The new folder, to be filled. It has the name of the old one.</summary>
    public string Folder { get; }

    private string Former => FormerIn(_container, _target);

    /// <summary>Makes an empty new folder.</summary>
    /// <param name="folder">The folder to replace, which exists.</param>
    /// <exception cref="IOException">Nothing can be written beside the folder.</exception>
    /// <exception cref="UnauthorizedAccessException">Nothing may be written beside the folder.</exception>
    public static FolderReplacement Begin(string folder) => Begin(folder, exchanges: true);

    internal static FolderReplacement Begin(string folder, bool exchanges)
    {
        var made = new FolderReplacement(FolderLock.FullPathOf(folder), exchanges);
        try
        {
            Directory.CreateDirectory(made._container);
            UnfinishedMark.Write(made._container, "replacement of " + Path.GetFileName(made._target));
            Directory.CreateDirectory(made.Folder);
            return made;
        }
        catch
        {
            made.Dispose();
            throw;
        }
    }

    /// <summary>
    /// Puts the new folder in the place of the old one, and deletes the old one when the new name is on the disk. The content of the new
    /// folder is the caller's to bring there.
    /// </summary>
    /// <returns>Where the old one still is, if it could not be deleted; otherwise null.</returns>
    /// <exception cref="IOException">The old folder cannot be replaced; it is as it was.</exception>
    /// <exception cref="UnauthorizedAccessException">The old folder may not be replaced; it is as it was.</exception>
    public string? Complete()
    {
        if (!OperatingSystem.IsWindows())
        {
            File.SetUnixFileMode(Folder, File.GetUnixFileMode(_target));
        }

        SyncNames();
        bool isExchanged = _exchanges && FolderExchange.TryRun(Folder, _target);
        if (!isExchanged)
        {
            MoveIn();
        }

        try
        {
            SyncNames();
        }
        catch
        {
            // Nothing of the old folder is deleted until it is back.
            _isComplete = true;
            PutBack(isExchanged);
            _isComplete = false;
            throw;
        }

        _isComplete = true;
        return TryDelete(_container) ? null : _container;
    }

    /// <summary>Deletes the new folder if it has not replaced the old one.</summary>
    public void Dispose()
    {
        // Without the target, the former folder is the only one, and stays for the next command to put back.
        if (!_isComplete && Directory.Exists(_target))
        {
            TryDelete(_container);
        }
    }

    /// <summary>Puts back or deletes what replacements of a folder left when they were stopped. The caller holds its lock.</summary>
    /// <param name="target">The folder, with all links resolved; it need not exist.</param>
    /// <exception cref="IOException">The folder that holds it cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder that holds it cannot be read.</exception>
    internal static void Recover(string target)
    {
        string parent = Path.GetDirectoryName(target) ?? target;
        foreach (string container in Directory.GetDirectories(parent, "*.partial"))
        {
            if (AtomicFile.TargetOf(Path.GetFileName(container)) != Path.GetFileName(target) || !IsOurs(container))
            {
                continue;
            }

            if (!Path.Exists(target) && Directory.Exists(FormerIn(container, target)))
            {
                Directory.Move(FormerIn(container, target), target);
            }

            TryDelete(container);
        }
    }

    private void MoveIn()
    {
        Directory.Move(_target, Former);
        try
        {
            Directory.Move(Folder, _target);
        }
        catch
        {
            Directory.Move(Former, _target);
            throw;
        }
    }

    private void PutBack(bool isExchanged)
    {
        if (isExchanged)
        {
            FolderExchange.TryRun(Folder, _target);
        }
        else
        {
            Directory.Move(_target, Folder);
            Directory.Move(Former, _target);
        }
    }

    /// <summary>Brings to the disk what the folders are called.</summary>
    private void SyncNames()
    {
        var names = new SyncBatch();
        names.AddFolder(_container);
        names.AddFolder(Path.GetDirectoryName(_target) ?? _target);
        names.Flush();
    }

    private static bool IsOurs(string container) =>
        new FileInfo(container).LinkTarget is null
        && (File.Exists(Path.Combine(container, UnfinishedMark.FileName)) || UnfinishedMark.IsAllOf(container));

    private static string FormerIn(string container, string target) => Path.Combine(container, Path.GetFileName(target) + FormerSuffix);

    private static bool TryDelete(string container)
    {
        try
        {
            if (Directory.Exists(container))
            {
                // The mark goes last, so that what remains is known as ours.
                Directory.GetDirectories(container).ToList().ForEach(folder => Directory.Delete(folder, recursive: true));
                UnfinishedMark.Delete(container);
                Directory.Delete(container);
            }

            return true;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }
}
