using System.Runtime.InteropServices;

namespace Harvester.Datasets.Files;

/// <summary>Creates hard links, for which .NET has no method.</summary>
internal static class HardLink
{
    /// <summary>Creates a link; false if that is not possible, as across file systems.</summary>
    public static bool TryCreate(string name, string existing) =>
        OperatingSystem.IsWindows() ? CreateHardLink(name, existing, IntPtr.Zero) : Link(existing, name) == 0;

    [DefaultDllImportSearchPaths(DllImportSearchPath.System32)]
    [DllImport("kernel32", EntryPoint = "CreateHardLinkW", CharSet = CharSet.Unicode)]
    [return: MarshalAs(UnmanagedType.Bool)]
    private static extern bool CreateHardLink(string name, string existing, IntPtr security);

    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    [DllImport("libc", EntryPoint = "link")]
    private static extern int Link([MarshalAs(UnmanagedType.LPUTF8Str)] string existing, [MarshalAs(UnmanagedType.LPUTF8Str)] string name);
}
