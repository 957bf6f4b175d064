using System.Runtime.InteropServices;

// Load only the system's own libraries, never one of the same name beside the game.
[assembly: DefaultDllImportSearchPaths(DllImportSearchPath.System32)]

namespace Harvester.Play.Screen.Windows;

/// <summary>Functions for windows and monitors, declared as in winuser.h.</summary>
internal static class User32
{
    public const int ExtendedStyle = -20;
    public const int StyleTransparent = 0x20;
    public const int StyleToolWindow = 0x80;
    public const int StyleLayered = 0x80000;
    public const int LayerHasAlpha = 2;
    public const uint Owner = 4;

    public delegate bool WindowVisitor(IntPtr window, IntPtr state);

    public delegate bool MonitorVisitor(IntPtr monitor, IntPtr context, ref NativeRectangle area, IntPtr state);

    [DllImport("user32")]
    [return: MarshalAs(UnmanagedType.Bool)]
    public static extern bool EnumWindows(WindowVisitor visitor, IntPtr state);

    [DllImport("user32")]
    [return: MarshalAs(UnmanagedType.Bool)]
    public static extern bool EnumDisplayMonitors(IntPtr context, IntPtr clip, MonitorVisitor visitor, IntPtr state);

    [DllImport("user32")]
    [return: MarshalAs(UnmanagedType.Bool)]
    public static extern bool IsWindowVisible(IntPtr window);

    [DllImport("user32")]
    [return: MarshalAs(UnmanagedType.Bool)]
    public static extern bool IsIconic(IntPtr window);

    [DllImport("user32")]
    public static extern IntPtr GetWindow(IntPtr window, uint relation);

    [DllImport("user32")]
    public static extern uint GetWindowThreadProcessId(IntPtr window, out int processId);

    [DllImport("user32", EntryPoint = "GetWindowLongW")]
    public static extern int GetWindowLong(IntPtr window, int index);

    [DllImport("user32", EntryPoint = "GetClassNameW", CharSet = CharSet.Unicode)]
    public static extern int GetClassName(IntPtr window, [Out] char[] name, int capacity);

    [DllImport("user32")]
    [return: MarshalAs(UnmanagedType.Bool)]
    public static extern bool GetWindowRect(IntPtr window, out NativeRectangle bounds);

    [DllImport("user32")]
    [return: MarshalAs(UnmanagedType.Bool)]
    public static extern bool GetClientRect(IntPtr window, out NativeRectangle client);

    [DllImport("user32")]
    [return: MarshalAs(UnmanagedType.Bool)]
    public static extern bool ClientToScreen(IntPtr window, ref NativePoint point);

    [DllImport("user32")]
    [return: MarshalAs(UnmanagedType.Bool)]
    public static extern bool GetWindowPlacement(IntPtr window, ref NativePlacement placement);

    [DllImport("user32")]
    [return: MarshalAs(UnmanagedType.Bool)]
    public static extern bool GetLayeredWindowAttributes(IntPtr window, out uint colourKey, out byte alpha, out int flags);

    [DllImport("user32")]
    public static extern IntPtr SetThreadDpiAwarenessContext(IntPtr context);

    [DllImport("user32")]
    public static extern IntPtr GetDC(IntPtr window);

    [DllImport("user32")]
    public static extern int ReleaseDC(IntPtr window, IntPtr context);
}
