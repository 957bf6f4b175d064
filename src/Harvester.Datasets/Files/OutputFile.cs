using Harvester.Sessions.Files;

namespace Harvester.Datasets.Files;

/// <summary>A file that is the result of a command. Only one process writes it at a time, and deletes what a stopped one left.</summary>
public static class OutputFile
{
    /// <summary>Writes a file whole or not at all, in place of an older one.</summary>
    /// <param name="path">The file; its folder must exist.</param>
    /// <param name="content">Writes the content to a stream and leaves the stream open.</param>
    /// <exception cref="OccupiedFolderException">Another process is writing it.</exception>
    /// <exception cref="IOException">The file cannot be written; an older one is unchanged.</exception>
    /// <exception cref="UnauthorizedAccessException">The file cannot be written; an older one is unchanged.</exception>
    public static void Write(string path, Action<Stream> content)
    {
        using FolderLock? held = Lock(path);
        AtomicFile.Write(path, content);
    }

    /// <summary>Locks a file for writing it by other means, and deletes what a stopped command left of it.</summary>
    /// <returns>The lock; null if the folder of the file does not exist, so that it cannot be written.</returns>
    /// <exception cref="OccupiedFolderException">Another process is writing it.</exception>
    public static FolderLock? Lock(string path) =>
        Directory.Exists(Path.GetDirectoryName(Path.GetFullPath(path))) ? FolderLock.Take(path) : null;
}
