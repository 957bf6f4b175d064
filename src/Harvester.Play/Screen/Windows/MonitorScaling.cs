using System.Runtime.InteropServices;

namespace Harvester.Play.Screen.Windows;

/// <summary>The scaling of monitors, available from Windows 8.1 on.</summary>
internal static class MonitorScaling
{
    private const uint Nearest = 2;
    private const int EffectiveDpi = 0;

    /// <summary>Dots per inch of the monitor that shows most of a window; null if Windows does not report it.</summary>
    public static int? DpiOf(IntPtr window)
    {
        try
        {
            return GetDpiForMonitor(MonitorFromWindow(window, Nearest), EffectiveDpi, out uint dpi, out _) == 0 ? (int)dpi : null;
        }
        catch (Exception exception) when (exception is DllNotFoundException or EntryPointNotFoundException)
        {
            return null;
        }
    }

    [DllImport("user32")]
    private static extern IntPtr MonitorFromWindow(IntPtr window, uint otherwise);

    [DllImport("shcore")]
    private static extern int GetDpiForMonitor(IntPtr monitor, int kind, out uint horizontal, out uint vertical);
}
