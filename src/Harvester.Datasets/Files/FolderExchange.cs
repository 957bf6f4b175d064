using System.Runtime.InteropServices;

namespace Harvester.Datasets.Files;

/// <summary>Gives two folders each other's names in one step, which .NET has no call for.</summary>
internal static class FolderExchange
{
    // EINVAL, ENOSYS and EOPNOTSUPP: the file system or the system cannot do it.
    private static readonly int[] Unsupported = [22, 38, 95];

    /// <summary>Exchanges two folders of one file system.</summary>
    /// <returns>False where that cannot be done in one step; nothing has changed then.</returns>
    /// <exception cref="IOException">The exchange is refused; nothing has changed.</exception>
    public static bool TryRun(string one, string other)
    {
        if (!OperatingSystem.IsLinux())
        {
            return false;
        }

        const int workingFolder = -100;
        const uint exchange = 2;
        try
        {
            if (RenameAt(workingFolder, one, workingFolder, other, exchange) == 0)
            {
                return true;
            }
        }
        catch (EntryPointNotFoundException)
        {
            return false;
        }

        int error = Marshal.GetLastPInvokeError();
        return Array.IndexOf(Unsupported, error) >= 0
            ? false
            : throw new IOException($"'{other}' cannot be replaced: {Marshal.GetPInvokeErrorMessage(error)}.", error);
    }

    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    [DllImport("libc", EntryPoint = "renameat2", SetLastError = true)]
    private static extern int RenameAt(
        int folder,
        [MarshalAs(UnmanagedType.LPUTF8Str)] string name,
        int otherFolder,
        [MarshalAs(UnmanagedType.LPUTF8Str)] string otherName,
        uint flags
    );
}
