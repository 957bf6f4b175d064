namespace Harvester.Sessions.Files;

/// <summary>
/// Files that were written and are to be brought to the disk together, before something is written that relies on them. On Windows the
/// names in folders are left to the journal of the file system, because folders cannot be flushed there.
/// </summary>
public sealed class SyncBatch
{
    /// <summary>The most frames whose lines are held back until a batch is on the disk.</summary>
    public const int MaxFrames = 16;

    private readonly List<string> _files = [];
    private readonly HashSet<string> _folders = new(StringComparer.Ordinal);

    /// <summary>The longest time that a line is held back.</summary>
    public static TimeSpan MaxAge { get; } = TimeSpan.FromSeconds(1);

    /// <summary>Takes a file that was written, or given a second name; and with it its name in its folder.</summary>
    /// <param name="path">The file.</param>
    public void Add(string path)
    {
        _files.Add(path);
        AddFolder(Path.GetDirectoryName(Path.GetFullPath(path))!);
    }

    /// <summary>Takes the names in a folder.</summary>
    /// <param name="path">The folder.</param>
    public void AddFolder(string path) => _folders.Add(path);

    /// <summary>
    /// Brings all of it to the disk: first the files, then the folders. What was taken is forgotten, also after a failure.
    /// </summary>
    /// <exception cref="IOException">The disk refuses; nothing is known of the files then.</exception>
    /// <exception cref="UnauthorizedAccessException">A file may not be opened.</exception>
    public void Flush()
    {
        string[] files = [.. _files];
        string[] folders = [.. _folders];
        _files.Clear();
        _folders.Clear();
        foreach (string file in files)
        {
            DiskSync.File(file);
        }

        foreach (string folder in folders)
        {
            DiskSync.Folder(folder);
        }
    }
}
