using Harvester.Sessions.Imaging;

namespace Harvester.Play.Screen.Windows;

/// <summary>The desktop of Windows, by user32, gdi32 and dwmapi only.</summary>
internal sealed class WindowsDesktop : IDesktop, IDisposable
{
    private readonly WindowReader _reader = new();
    private ScreenBitmap? _bitmap;

    public DesktopView Observe()
    {
        using var pixels = PhysicalPixels.Enter();
        var windows = new List<TopLevelWindow>();
        var monitors = new List<DesktopRectangle>();
        User32.EnumWindows(
            (window, _) =>
            {
                if (_reader.Read(window) is { } facts)
                {
                    windows.Add(facts);
                }

                return true;
            },
            IntPtr.Zero
        );
        User32.EnumDisplayMonitors(
            IntPtr.Zero,
            IntPtr.Zero,
            (IntPtr _, IntPtr _, ref NativeRectangle area, IntPtr _) =>
            {
                monitors.Add(area.ToPixels());
                return true;
            },
            IntPtr.Zero
        );
        return new DesktopView(windows, monitors);
    }

    public DisplayFacts FactsOf(long window)
    {
        using var pixels = PhysicalPixels.Enter();
        bool isExclusive = Shell32.SHQueryUserNotificationState(out int state) == 0 && state == Shell32.RunningFullScreen;
        return new DisplayFacts(MonitorScaling.DpiOf(new IntPtr(window)), isExclusive) { IsHdr = AdvancedColour.IsOnAnyMonitor() };
    }

    public bool TryCopy(DesktopRectangle area, PixelBuffer target)
    {
        using var pixels = PhysicalPixels.Enter();
        if (_bitmap?.Size != target.Size)
        {
            _bitmap?.Dispose();
            _bitmap = null;
            _bitmap = new ScreenBitmap(target.Size);
        }

        if (!_bitmap!.TryCopyScreen(area.Left, area.Top))
        {
            return false;
        }

        _bitmap.ReadInto(target);
        return true;
    }

    public void Dispose() => _bitmap?.Dispose();
}
