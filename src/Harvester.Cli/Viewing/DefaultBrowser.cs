using System.ComponentModel;
using System.Diagnostics;

namespace Harvester.Cli.Viewing;

/// <summary>The browser that the user prefers.</summary>
internal static class DefaultBrowser
{
    /// <summary>
    /// Opens an address by a file that leads to it: other users can read the arguments of a process. Without a browser or a place for the
    /// file nothing happens, because the address has been printed.
    /// </summary>
    /// <param name="address">The address.</param>
    /// <returns>The file, to be removed when the address is no longer served; null if it cannot be written.</returns>
    public static AddressFile? Open(Uri address)
    {
        AddressFile? file = null;
        try
        {
            file = AddressFile.Create(address);
            using Process? browser = Process.Start(StartOf(file));
        }
        catch (Exception e) when (e is Win32Exception or IOException or UnauthorizedAccessException)
        {
            // There is no browser, or no place for the file.
        }

        return file;
    }

    /// <summary>How the system's browser is started.</summary>
    internal static ProcessStartInfo StartOf(AddressFile file) =>
        OperatingSystem.IsWindows()
            ? new(file.Path) { UseShellExecute = true }
            : new(OperatingSystem.IsMacOS() ? "open" : "xdg-open", [file.Path])
            {
                RedirectStandardOutput = true,
                RedirectStandardError = true,
            };
}
