using System.Runtime.InteropServices;

namespace Harvester.Sessions.Files;

/// <summary>Opens files for reading and rejects what is not a regular file: a pipe blocks forever, and a device may have no end.</summary>
public static class RegularFile
{
    private const int StatxLength = 256;
    private const int ModeAt = 28;
    private const ushort TypeMask = 0xF000;
    private const ushort Pipe = 0x1000;
    private const ushort CharacterDevice = 0x2000;
    private const ushort BlockDevice = 0x6000;
    private const ushort Socket = 0xC000;

    /// <summary>Opens a file for reading.</summary>
    /// <param name="path">The file; links are followed.</param>
    /// <param name="share">What other processes may do with the file while it is open.</param>
    /// <exception cref="IOException">The file is a pipe, a socket or a device, has an impossible name, or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The path is a folder, or cannot be read.</exception>
    public static FileStream OpenRead(string path, FileShare share = FileShare.Read)
    {
        Check(path);
        return new FileStream(path, FileMode.Open, FileAccess.Read, share);
    }

    /// <summary>Rejects a pipe, a socket or a device. A missing file is accepted; opening it reports that.</summary>
    /// <param name="path">The file; links are followed.</param>
    /// <exception cref="IOException">The file is one of these, or its name has a NUL character.</exception>
    public static void Check(string path)
    {
        if (path.IndexOf('\0') >= 0)
        {
            throw new IOException("The name of a file has a NUL character, which no file system allows.");
        }

        if (IsSpecial(path))
        {
            throw new IOException($"'{path}' is a pipe, a socket or a device. Name a regular file.");
        }
    }

    /// <summary>Whether a path leads to a pipe, a socket or a device.</summary>
    /// <param name="path">The path; links are followed.</param>
    // On Windows the runtime opens only files on a disk. Elsewhere it opens everything without reporting what it is.
    public static bool IsSpecial(string path) =>
        RuntimeInformation.IsOSPlatform(OSPlatform.Linux) && TypeOf(path) is Pipe or CharacterDevice or BlockDevice or Socket;

    private static int TypeOf(string path)
    {
        const int workingFolder = -100;
        const uint type = 1;
        byte[] found = new byte[StatxLength];
        return Statx(workingFolder, path, 0, type, found) == 0 ? BitConverter.ToUInt16(found, ModeAt) & TypeMask : 0;
    }

    // Unlike that of stat, this structure is the same on all processors.
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    [DllImport("libc", EntryPoint = "statx")]
    private static extern int Statx(int folder, [MarshalAs(UnmanagedType.LPUTF8Str)] string path, int flags, uint mask, byte[] found);
}
