using System.Runtime.InteropServices;

namespace Harvester.Play.Screen.Windows;

/// <summary>Reads the properties of one window.</summary>
internal sealed class WindowReader
{
    private const string ConsoleClass = "ConsoleWindowClass";
    private readonly char[] _className = new char[256];

    /// <summary>The properties of a window; null if it is not visible or has just been closed.</summary>
    public TopLevelWindow? Read(IntPtr window)
    {
        if (!User32.IsWindowVisible(window) || !User32.GetWindowRect(window, out NativeRectangle frame))
        {
            return null;
        }

        _ = User32.GetWindowThreadProcessId(window, out int processId);
        bool isMinimised = User32.IsIconic(window);
        int style = User32.GetWindowLong(window, User32.ExtendedStyle);
        DesktopRectangle bounds = WindowManager.VisibleBounds(window) ?? frame.ToPixels();
        return new TopLevelWindow(
            window.ToInt64(),
            processId,
            IsApplication(window, style),
            isMinimised,
            ShowsNothing(window, style),
            bounds,
            isMinimised ? default : ClientOf(window),
            isMinimised ? RestoredArea(window) : bounds.Area
        );
    }

    private static bool ShowsNothing(IntPtr window, int style)
    {
        if (WindowManager.IsCloaked(window))
        {
            return true;
        }

        if ((style & User32.StyleLayered) == 0)
        {
            return false;
        }

        bool isInvisible =
            User32.GetLayeredWindowAttributes(window, out _, out byte alpha, out int flags)
            && (flags & User32.LayerHasAlpha) != 0
            && alpha == 0;
        return isInvisible || (style & User32.StyleTransparent) != 0;
    }

    private static DesktopRectangle ClientOf(IntPtr window)
    {
        NativePoint corner = default;
        return User32.GetClientRect(window, out NativeRectangle client) && User32.ClientToScreen(window, ref corner)
            ? new DesktopRectangle(corner.X, corner.Y, corner.X + client.Right, corner.Y + client.Bottom)
            : default;
    }

    private static long RestoredArea(IntPtr window)
    {
        var placement = new NativePlacement { Length = Marshal.SizeOf<NativePlacement>() };
        return User32.GetWindowPlacement(window, ref placement) ? placement.Normal.ToPixels().Area : 0;
    }

    private bool IsApplication(IntPtr window, int style) =>
        (style & User32.StyleToolWindow) == 0
        && User32.GetWindow(window, User32.Owner) == IntPtr.Zero
        && new string(_className, 0, User32.GetClassName(window, _className, _className.Length)) != ConsoleClass;
}
