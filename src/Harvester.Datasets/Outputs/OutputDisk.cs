using System.Runtime.InteropServices;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Outputs;

/// <summary>
/// Finds out whether a disk takes an output folder, before a command begins what takes long, such as building a town or reading all
/// labels. Nothing is left behind.
/// </summary>
public static class OutputDisk
{
    private const int WriteAndEnter = 3;

    /// <summary>Makes the folder for a moment if it is missing, and looks at its permissions and at the free space.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="option">The option that names it.</param>
    /// <param name="minFreeBytes">Space that is to stay free, bytes; 0 watches nothing.</param>
    /// <exception cref="IOException">No file can be written there.</exception>
    /// <exception cref="LowSpaceException">Less space is free than is to stay free.</exception>
    public static void Check(string folder, string option, long minFreeBytes = 0)
    {
        if (OutputFolder.FileInTheWayOf(folder) is { } file)
        {
            throw new IOException($"'{file}' is a file. Name a folder with {option}.");
        }

        Stack<string> missing = MissingIn(folder);
        try
        {
            if (missing.Count > 0)
            {
                Try(missing);
            }
            else if (!OperatingSystem.IsWindows() && Access(folder, WriteAndEnter) != 0)
            {
                throw new UnauthorizedAccessException();
            }
        }
        catch (Exception e) when (e is UnauthorizedAccessException or FileNotFoundException or DirectoryNotFoundException)
        {
            throw new IOException(
                $"Nothing can be written to '{folder}'. Change the permissions, or name another folder with {option}.",
                e
            );
        }

        new SpaceWatch(folder, minFreeBytes).Check();
    }

    /// <summary>The folder and those above it that do not exist, the uppermost first.</summary>
    private static Stack<string> MissingIn(string folder)
    {
        var missing = new Stack<string>();
        for (
            string? each = Path.TrimEndingDirectorySeparator(Path.GetFullPath(folder));
            each is not null && !Directory.Exists(each);
            each = Path.GetDirectoryName(each)
        )
        {
            missing.Push(each);
        }

        return missing;
    }

    private static void Try(Stack<string> folders)
    {
        var made = new Stack<string>();
        try
        {
            foreach (string folder in folders)
            {
                Directory.CreateDirectory(folder);
                made.Push(folder);
            }
        }
        finally
        {
            foreach (string folder in made)
            {
                Remove(folder);
            }
        }
    }

    private static void Remove(string folder)
    {
        try
        {
            Directory.Delete(folder);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // Another process has begun to use it.
        }
    }

    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    [DllImport("libc", EntryPoint = "access")]
    private static extern int Access([MarshalAs(UnmanagedType.LPUTF8Str)] string path, int mode);
}
