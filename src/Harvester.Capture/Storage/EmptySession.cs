using Harvester.Sessions.Files;

namespace Harvester.Capture.Storage;

/// <summary>Removes the folder of a session without frames.</summary>
internal static class EmptySession
{
    /// <summary>
    /// Removes a folder that holds nothing but folders, empty files, the manifest and the texts that the session began with. With anything
    /// else in it, such as a picture or a link, the folder stays as it is.
    /// </summary>
    /// <param name="folder">The folder.</param>
    /// <param name="texts">Paths of the session's own texts in it, with forward slashes.</param>
    public static void Remove(string folder, IEnumerable<string> texts)
    {
        try
        {
            var own = new HashSet<string>(
                texts.Concat([SessionDirectory.Header, Manifest.FileName]).Select(name => Path.GetFullPath(Path.Combine(folder, name)))
            );
            var folders = new List<DirectoryInfo> { new(folder) };
            var files = new List<FileInfo>();
            for (int i = 0; i < folders.Count; i++)
            {
                folders.AddRange(folders[i].GetDirectories());
                files.AddRange(folders[i].GetFiles());
            }

            if (folders.Exists(IsLink) || !files.TrueForAll(file => !IsLink(file) && (file.Length == 0 || own.Contains(file.FullName))))
            {
                return;
            }

            files.ForEach(file => file.Delete());
            folders.Reverse();
            folders.ForEach(each => each.Delete());
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            // Another program holds something in it: what is left stays.
        }
    }

    private static bool IsLink(FileSystemInfo entry) => (entry.Attributes & FileAttributes.ReparsePoint) != 0;
}
