using System;
using System.IO;
using System.Runtime.InteropServices;

namespace Harvester.Sessions.Files;

/// <summary>Opens files for reading and refuses what only looks like one: a pipe blocks for ever, and a device may have no end.</summary>
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
    /// <param name="share">What others may do with it meanwhile.</param>
    /// <exception cref="IOException">It is a pipe, a socket or a device, or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It is a folder, or may not be read.</exception>
    public static FileStream OpenRead(string path, FileShare share = FileShare.Read)
    {
        Check(path);
        return new FileStream(path, FileMode.Open, FileAccess.Read, share);
    }

    /// <summary>Refuses a pipe, a socket or a device. What is not there is left to those who open it.</summary>
    /// <param name="path">The file; links are followed.</param>
    /// <exception cref="IOException">It is one of these.</exception>
    public static void Check(string path)
    {
        if (IsSpecial(path))
        {
            throw new IOException($"'{path}' is a pipe, a socket or a device. Name a regular file.");
        }
    }

    /// <summary>Whether a path leads to a pipe, a socket or a device.</summary>
    /// <param name="path">The path; links are followed.</param>
    // On Windows the runtime refuses to open what is no file of a disk. Elsewhere it opens everything, and does not tell what it is.
    public static bool IsSpecial(string path) =>
        RuntimeInformation.IsOSPlatform(OSPlatform.Linux) && TypeOf(path) is Pipe or CharacterDevice or BlockDevice or Socket;

    private static int TypeOf(string path)
    {
        const int workingFolder = -100;
        const uint type = 1;
        byte[] found = new byte[StatxLength];
        return Statx(workingFolder, path, 0, type, found) == 0 ? BitConverter.ToUInt16(found, ModeAt) & TypeMask : 0;
    }

    // Its structure is the same on all processors, unlike that of stat.
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    [DllImport("libc", EntryPoint = "statx")]
    private static extern int Statx(int folder, [MarshalAs(UnmanagedType.LPUTF8Str)] string path, int flags, uint mask, byte[] found);
}
