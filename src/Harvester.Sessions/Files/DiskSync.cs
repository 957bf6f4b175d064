#if NET
using System;
#endif
using System.IO;
#if NET
using System.Runtime.InteropServices;
#endif
using Microsoft.Win32.SafeHandles;

namespace Harvester.Sessions.Files;

/// <summary>
/// What the runtime has no call for: to bring the entries of a folder to the disk, and to hear of an error when a file is closed. Windows
/// needs neither: its file systems keep a journal of folders, and it reports such errors when a file is flushed.
/// </summary>
internal static class DiskSync
{
    /// <summary>Brings the names in a folder to the disk, as far as the file system can.</summary>
    /// <exception cref="IOException">The disk refuses.</exception>
    public static void Folder(string path)
    {
#if NET
        if (OperatingSystem.IsWindows())
        {
            return;
        }

        int folder = Open(path, 0);
        if (folder < 0)
        {
            throw Failure(path);
        }

        try
        {
            // Some file systems cannot synchronise a folder (EINVAL); no program can do more there.
            const int invalid = 22;
            if (FSync(folder) != 0 && Marshal.GetLastPInvokeError() != invalid)
            {
                throw Failure(path);
            }
        }
        finally
        {
            _ = Close(folder);
        }
#endif
    }

    /// <summary>
    /// Asks for the error that closing a file would give. Network file systems report there that a quota is used up, and the runtime
    /// ignores it. A second descriptor is closed, since the first belongs to the runtime: the system flushes at every close.
    /// </summary>
    /// <exception cref="IOException">What was written cannot be kept.</exception>
    public static void CheckClose(SafeFileHandle handle)
    {
#if NET
        if (OperatingSystem.IsWindows())
        {
            return;
        }

        int second = Duplicate((int)handle.DangerousGetHandle());
        if (second < 0 || Close(second) != 0)
        {
            throw Failure(null);
        }
#endif
    }

#if NET
    private static IOException Failure(string? path)
    {
        int error = Marshal.GetLastPInvokeError();
        string what = Marshal.GetPInvokeErrorMessage(error);
        return new IOException(path is null ? what : $"{what} : '{path}'", error);
    }

    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    [DllImport("libc", EntryPoint = "open", SetLastError = true)]
    private static extern int Open([MarshalAs(UnmanagedType.LPUTF8Str)] string path, int flags);

    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    [DllImport("libc", EntryPoint = "fsync", SetLastError = true)]
    private static extern int FSync(int descriptor);

    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    [DllImport("libc", EntryPoint = "dup", SetLastError = true)]
    private static extern int Duplicate(int descriptor);

    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    [DllImport("libc", EntryPoint = "close", SetLastError = true)]
    private static extern int Close(int descriptor);
#endif
}
