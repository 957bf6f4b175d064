using System;
using System.ComponentModel;
using System.Diagnostics;

namespace Harvester.Cli.Viewing;

/// <summary>The browser that the user prefers.</summary>
internal static class DefaultBrowser
{
    /// <summary>Opens an address. Without a browser nothing happens, because the address has been printed.</summary>
    public static void Open(Uri address)
    {
        ProcessStartInfo start = OperatingSystem.IsWindows() ? new(address.AbsoluteUri) { UseShellExecute = true }
            : new(OperatingSystem.IsMacOS() ? "open" : "xdg-open", [address.AbsoluteUri])
            {
                RedirectStandardOutput = true,
                RedirectStandardError = true,
            };
        try
        {
            using Process? browser = Process.Start(start);
        }
        catch (Win32Exception)
        {
            // There is no browser.
        }
    }
}
