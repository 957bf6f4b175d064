using System.Text;

namespace Harvester.Sessions.Files;

/// <summary>
/// Opens files that are written in place, such as the labels of a running harvest, and follows no link that somebody has planted under
/// their name. .NET Framework cannot tell links from other files; on Windows, making a link takes special rights.
/// </summary>
public static class AppendedFile
{
    // What could not be written must not be tried again when the file is closed.
    private const int Unbuffered = 1;

    private static readonly UTF8Encoding Utf8 = new(encoderShouldEmitUTF8Identifier: false);

    /// <summary>Opens a file at its end, and makes it if it is missing. Others may read it meanwhile.</summary>
    /// <param name="path">The file; its folder must exist.</param>
    /// <param name="access">Writing, or reading and writing.</param>
    /// <exception cref="IOException">It is a link, a pipe, a socket or a device, or cannot be opened.</exception>
    /// <exception cref="UnauthorizedAccessException">It cannot be written.</exception>
    public static FileStream Open(string path, FileAccess access = FileAccess.Write)
    {
        if (IsLink(path))
        {
            throw new IOException($"'{path}' is a link, which is not followed when writing. Delete it, or name another folder.");
        }

        RegularFile.Check(path);
        var file = new FileStream(path, FileMode.OpenOrCreate, access, FileShare.Read, Unbuffered);
        file.Seek(0, SeekOrigin.End);
        return file;
    }

    /// <summary>Appends lines; a part of them, as a full disk leaves it, is removed.</summary>
    /// <param name="file">The file, at its end.</param>
    /// <param name="lines">The lines without line feeds.</param>
    /// <param name="isDurable">Whether the lines are on the disk when this returns.</param>
    /// <exception cref="IOException">The lines cannot be written or stored.</exception>
    public static void AppendLines(FileStream file, IReadOnlyList<string> lines, bool isDurable)
    {
        long end = file.Length;
        byte[] bytes = Utf8.GetBytes(string.Join("\n", lines) + "\n");
        try
        {
            file.Write(bytes, 0, bytes.Length);
            file.Flush(isDurable);
            DiskSync.CheckClose(file.SafeFileHandle);
        }
        catch
        {
            file.SetLength(end);
            throw;
        }
    }

    /// <summary>Refuses a folder that is a link: what is written to it would go elsewhere.</summary>
    /// <exception cref="IOException">The folder is a link.</exception>
    public static void RefuseLink(string folder)
    {
        if ((File.GetAttributes(folder) & FileAttributes.ReparsePoint) != 0)
        {
            throw new IOException($"'{folder}' is a link, which is not followed when writing. Delete it, or name another folder.");
        }
    }

    /// <summary>Whether a path is that of a link, whatever it leads to.</summary>
    internal static bool IsLink(string path)
    {
#if NET
        return new FileInfo(path).LinkTarget is not null;
#else
        return false;
#endif
    }
}
