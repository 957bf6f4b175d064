using System.Runtime.InteropServices;

namespace Harvester.Play.Screen.Windows;

/// <summary>Properties of a window from the desktop window manager (dwmapi.h). If it does not run, no window is cloaked.</summary>
internal static class WindowManager
{
    private const int ExtendedFrameBounds = 9;
    private const int Cloaked = 14;

    /// <summary>Whether the window is not shown although it counts as visible: on another virtual desktop, or of a suspended app.</summary>
    public static bool IsCloaked(IntPtr window) => GetWindowAttribute(window, Cloaked, out int cloaked, sizeof(int)) == 0 && cloaked != 0;

    /// <summary>The window's visible bounds, without the invisible border for resizing; null if unknown.</summary>
    public static DesktopRectangle? VisibleBounds(IntPtr window) =>
        GetWindowAttribute(window, ExtendedFrameBounds, out NativeRectangle bounds, Marshal.SizeOf<NativeRectangle>()) == 0
            ? bounds.ToPixels()
            : null;

    [DllImport("dwmapi", EntryPoint = "DwmGetWindowAttribute")]
    private static extern int GetWindowAttribute(IntPtr window, int attribute, out int value, int size);

    [DllImport("dwmapi", EntryPoint = "DwmGetWindowAttribute")]
    private static extern int GetWindowAttribute(IntPtr window, int attribute, out NativeRectangle value, int size);
}
