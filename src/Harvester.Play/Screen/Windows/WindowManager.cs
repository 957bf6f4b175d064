using System;
using System.Runtime.InteropServices;

namespace Harvester.Play.Screen.Windows;

/// <summary>
/// What the desktop window manager (dwmapi.h) says of a window. Where it does not run or knows nothing, nothing is cloaked.
/// </summary>
internal static class WindowManager
{
    private const int ExtendedFrameBounds = 9;
    private const int Cloaked = 14;

    /// <summary>
    /// Whether the window is kept from the screen though it counts as visible: on another virtual desktop, or a suspended app's.
    /// </summary>
    public static bool IsCloaked(IntPtr window) =>
        GetWindowAttribute(window, Cloaked, out int cloaked, sizeof(int)) == 0 && cloaked != 0;

    /// <summary>What the window shows of itself, without the invisible border for resizing; null where that is unknown.</summary>
    public static PixelRectangle? VisibleBounds(IntPtr window) =>
        GetWindowAttribute(window, ExtendedFrameBounds, out NativeRectangle bounds, Marshal.SizeOf<NativeRectangle>()) == 0
            ? bounds.ToPixels()
            : null;

    [DllImport("dwmapi", EntryPoint = "DwmGetWindowAttribute")]
    private static extern int GetWindowAttribute(IntPtr window, int attribute, out int value, int size);

    [DllImport("dwmapi", EntryPoint = "DwmGetWindowAttribute")]
    private static extern int GetWindowAttribute(IntPtr window, int attribute, out NativeRectangle value, int size);
}
