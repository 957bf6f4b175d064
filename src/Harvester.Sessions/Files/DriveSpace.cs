namespace Harvester.Sessions.Files;

/// <summary>Free space as the operating system reports it, quotas included. Network folders without a drive letter have none.</summary>
public sealed class DriveSpace : IFreeSpace
{
    /// <inheritdoc />
    public long? BytesFor(string folder)
    {
        string path = Path.GetFullPath(folder);
        try
        {
            // Elsewhere a disk is mounted at any folder, which must exist.
            string? place = Path.DirectorySeparatorChar == '\\' ? Path.GetPathRoot(path) : Existing(path);
            return place is null ? null : new DriveInfo(place).AvailableFreeSpace;
        }
        catch (Exception e) when (e is ArgumentException or IOException or UnauthorizedAccessException)
        {
            return null;
        }
    }

    private static string? Existing(string? path)
    {
        while (path is not null && !Directory.Exists(path))
        {
            path = Path.GetDirectoryName(path);
        }

        return path;
    }
}
