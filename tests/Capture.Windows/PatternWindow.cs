using System.ComponentModel;
using System.Diagnostics;
using System.Runtime.InteropServices;

namespace Harvester.Capture.Windows;

/// <summary>A window whose client area lies at known physical pixels and shows a known pattern.</summary>
internal sealed class PatternWindow : IDisposable
{
    private const string ClassName = "HarvesterPattern";

    /// <summary>Only a screen that shows something else takes so long.</summary>
    private static readonly TimeSpan MaxWaitForScreen = TimeSpan.FromSeconds(30);

    private static readonly Native.WindowProcedure Procedure = HandleMessage;
    private static readonly Dictionary<IntPtr, PatternWindow> Windows = [];
    private static bool _isRegistered;
    private readonly uint _style;
    private readonly uint _exStyle;
    private readonly IntPtr _handle;

    public PatternWindow(Area client, Pattern pattern, uint style = Native.Popup, uint exStyle = 0)
    {
        using var pixels = PhysicalThread.Enter();
        Register();
        Client = client;
        Pattern = pattern;
        _style = style;
        _exStyle = exStyle;
        Area frame = FrameOf(client);
        _handle = Native.CreateWindowEx(
            exStyle,
            ClassName,
            "pattern",
            style,
            frame.Left,
            frame.Top,
            frame.Width,
            frame.Height,
            IntPtr.Zero,
            IntPtr.Zero,
            IntPtr.Zero,
            IntPtr.Zero
        );
        if (_handle == IntPtr.Zero)
        {
            throw new Win32Exception();
        }

        Windows.Add(_handle, this);
        if ((exStyle & Native.ExLayered) != 0)
        {
            const uint hasAlpha = 2;
            Native.SetLayeredWindowAttributes(_handle, 0, 255, hasAlpha);
        }

        Native.ShowWindow(_handle, Native.ShowInactive);
        RaiseToTop();
    }

    public Area Client { get; private set; }

    public Pattern Pattern { get; private set; }

    /// <summary>
    /// Waits until the screen shows a pattern at the corners and in the middle of an area: another process, and on a busy machine a late
    /// one, puts there what a window has painted. When it never comes the grab that follows tells.
    /// </summary>
    public static void AwaitOnScreen(Area client, Pattern pattern)
    {
        using var pixels = PhysicalThread.Enter();
        long start = Stopwatch.GetTimestamp();
        while (!IsOnScreen(client, pattern) && Stopwatch.GetElapsedTime(start) < MaxWaitForScreen)
        {
            Settle();
        }
    }

    /// <summary>Lets windows paint themselves.</summary>
    public static void Settle()
    {
        const int rounds = 8;
        for (int i = 0; i < rounds; i++)
        {
            while (Native.PeekMessage(out Native.Message message, IntPtr.Zero, 0, 0, 1))
            {
                Native.DispatchMessage(ref message);
            }

            Thread.Sleep(5);
        }
    }

    /// <summary>Waits until the screen shows this window.</summary>
    public void AwaitOnScreen() => AwaitOnScreen(Client, Pattern);

    public void Place(Area client)
    {
        using var pixels = PhysicalThread.Enter();
        Client = client;
        Area frame = FrameOf(client);
        Native.SetWindowPos(
            _handle,
            IntPtr.Zero,
            frame.Left,
            frame.Top,
            frame.Width,
            frame.Height,
            Native.KeepOrder | Native.DoNotActivate
        );
        Repaint();
    }

    public void Show(Pattern pattern)
    {
        Pattern = pattern;
        Repaint();
    }

    public void Minimise() => Command(Native.ShowMinimised);

    public void Restore() => Command(Native.Restore);

    public void Hide() => Command(Native.Hide);

    public void RaiseToTop()
    {
        const uint keepPosition = 0x2;
        Native.SetWindowPos(_handle, Native.Top, 0, 0, 0, 0, Native.KeepSize | keepPosition | Native.DoNotActivate);
        Repaint();
    }

    public void BringToForeground()
    {
        Native.SetForegroundWindow(_handle);
        Settle();
    }

    public void Dispose()
    {
        Native.DestroyWindow(_handle);
        Windows.Remove(_handle);
        Settle();
    }

    private static void Register()
    {
        if (_isRegistered)
        {
            return;
        }

        var windowClass = new Native.WindowClass
        {
            Procedure = Marshal.GetFunctionPointerForDelegate(Procedure),
            ClassName = Marshal.StringToHGlobalUni(ClassName),
        };
        _isRegistered = Native.RegisterClass(ref windowClass) != 0 ? true : throw new Win32Exception();
    }

    private static bool IsOnScreen(Area client, Pattern pattern)
    {
        (int X, int Y)[] places =
        [
            (0, 0),
            (client.Width - 1, 0),
            (0, client.Height - 1),
            (client.Width - 1, client.Height - 1),
            (client.Width / 2, client.Height / 2),
        ];
        IntPtr desktop = Native.GetDC(IntPtr.Zero);
        bool isShown = places.All(place =>
            Native.GetPixel(desktop, client.Left + place.X, client.Top + place.Y)
            == (pattern.Red(place.X, place.Y) | (pattern.Green(place.X, place.Y) << 8) | (pattern.Blue(place.X, place.Y) << 16))
        );
        _ = Native.ReleaseDC(IntPtr.Zero, desktop);
        return isShown;
    }

    private static IntPtr HandleMessage(IntPtr window, uint message, IntPtr wide, IntPtr extra)
    {
        if (message == Native.Paint && Windows.TryGetValue(window, out PatternWindow? shown))
        {
            shown.Draw();
            return IntPtr.Zero;
        }

        return message == Native.EraseBackground ? new IntPtr(1) : Native.DefWindowProc(window, message, wide, extra);
    }

    private Area FrameOf(Area client)
    {
        var frame = new Native.Rectangle
        {
            Left = client.Left,
            Top = client.Top,
            Right = client.Left + client.Width,
            Bottom = client.Top + client.Height,
        };
        Native.AdjustWindowRectEx(ref frame, _style, false, _exStyle);
        return new Area(frame.Left, frame.Top, frame.Right - frame.Left, frame.Bottom - frame.Top);
    }

    private void Command(int command)
    {
        Native.ShowWindow(_handle, command);
        Repaint();
    }

    private void Repaint()
    {
        Native.InvalidateRect(_handle, IntPtr.Zero, false);
        Native.UpdateWindow(_handle);
        Settle();
    }

    private void Draw()
    {
        const int bytesPerPixel = 4;
        var bytes = new byte[Client.Width * Client.Height * bytesPerPixel];
        for (int y = 0, i = 0; y < Client.Height; y++)
        {
            for (int x = 0; x < Client.Width; x++, i += bytesPerPixel)
            {
                bytes[i] = Pattern.Blue(x, y);
                bytes[i + 1] = Pattern.Green(x, y);
                bytes[i + 2] = Pattern.Red(x, y);
            }
        }

        var header = new Native.BitmapHeader
        {
            Size = Marshal.SizeOf<Native.BitmapHeader>(),
            Width = Client.Width,
            Height = -Client.Height,
            Planes = 1,
            BitCount = bytesPerPixel * 8,
        };
        IntPtr context = Native.BeginPaint(_handle, out Native.PaintArea paint);
        _ = Native.SetDIBitsToDevice(context, 0, 0, Client.Width, Client.Height, 0, 0, 0, Client.Height, bytes, ref header, 0);
        Native.EndPaint(_handle, ref paint);
    }
}
