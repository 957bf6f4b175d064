using Microsoft.Win32.SafeHandles;
#if NET
using System.Runtime.InteropServices;
#endif

namespace Harvester.Sessions.Files;

/// <summary>
/// Two calls that the runtime lacks: writing a folder's entries to the disk, and the error of closing a file. Windows needs neither: its
/// file systems keep a journal of folders, and it reports such errors when a file is flushed.
/// </summary>
internal static class DiskSync
{
    /// <summary>Writes the content of a file to the disk, whichever process wrote it.</summary>
    /// <exception cref="IOException">The file cannot be opened or synchronised.</exception>
    /// <exception cref="UnauthorizedAccessException">Permission to open the file is denied.</exception>
    public static void File(string path)
    {
#if NET
        // Windows flushes only with write access; elsewhere the file may be read-only.
        FileAccess access = OperatingSystem.IsWindows() ? FileAccess.ReadWrite : FileAccess.Read;
        using SafeFileHandle file = System.IO.File.OpenHandle(path, FileMode.Open, access, FileShare.ReadWrite | FileShare.Delete);
        RandomAccess.FlushToDisk(file);
#else
        using var file = new FileStream(path, FileMode.Open, FileAccess.ReadWrite, FileShare.ReadWrite | FileShare.Delete);
        file.Flush(true);
#endif
    }

    /// <summary>Writes the names in a folder to the disk, as far as the file system can.</summary>
    /// <exception cref="IOException">The folder cannot be opened or synchronised.</exception>
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
    /// Throws the error that closing a file would give. Network file systems report an exhausted quota there, and the runtime ignores it. A
    /// second descriptor is closed, since the first belongs to the runtime: the system flushes at every close.
    /// </summary>
    /// <exception cref="IOException">The data written cannot be stored.</exception>
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
