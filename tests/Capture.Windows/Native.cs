using System.Runtime.InteropServices;

namespace Harvester.Capture.Windows;

/// <summary>The functions of Windows that put windows on the desktop; what is tested has its own.</summary>
internal static class Native
{
    public const uint OverlappedWindow = 0x00CF0000;
    public const uint Popup = 0x80000000;
    public const uint ExTransparent = 0x20;
    public const uint ExToolWindow = 0x80;
    public const uint ExLayered = 0x80000;
    public const int ShowMinimised = 6;
    public const int Restore = 9;
    public const int Hide = 0;
    public const int ShowInactive = 4;
    public const uint KeepSize = 0x1;
    public const uint KeepOrder = 0x4;
    public const uint DoNotActivate = 0x10;
    public const uint Paint = 0x000F;
    public const uint EraseBackground = 0x0014;

    public static readonly IntPtr Top = IntPtr.Zero;
    public static readonly IntPtr PerMonitorAware = new(-3);

    public delegate IntPtr WindowProcedure(IntPtr window, uint message, IntPtr wide, IntPtr extra);

    [DllImport("user32", EntryPoint = "RegisterClassW", SetLastError = true)]
    public static extern ushort RegisterClass(ref WindowClass windowClass);

    [DllImport("user32", EntryPoint = "CreateWindowExW", CharSet = CharSet.Unicode, SetLastError = true)]
    public static extern IntPtr CreateWindowEx(
        uint exStyle,
        string className,
        string title,
        uint style,
        int x,
        int y,
        int width,
        int height,
        IntPtr parent,
        IntPtr menu,
        IntPtr module,
        IntPtr state
    );

    [DllImport("user32")]
    public static extern bool DestroyWindow(IntPtr window);

    [DllImport("user32", EntryPoint = "DefWindowProcW")]
    public static extern IntPtr DefWindowProc(IntPtr window, uint message, IntPtr wide, IntPtr extra);

    [DllImport("user32", EntryPoint = "PeekMessageW")]
    public static extern bool PeekMessage(out Message message, IntPtr window, uint first, uint last, uint remove);

    [DllImport("user32", EntryPoint = "DispatchMessageW")]
    public static extern IntPtr DispatchMessage(ref Message message);

    [DllImport("user32")]
    public static extern bool ShowWindow(IntPtr window, int command);

    [DllImport("user32")]
    public static extern bool SetWindowPos(IntPtr window, IntPtr after, int x, int y, int width, int height, uint flags);

    [DllImport("user32")]
    public static extern bool AdjustWindowRectEx(ref Rectangle area, uint style, bool hasMenu, uint exStyle);

    [DllImport("user32")]
    public static extern bool SetLayeredWindowAttributes(IntPtr window, uint colourKey, byte alpha, uint flags);

    [DllImport("user32")]
    public static extern bool SetForegroundWindow(IntPtr window);

    [DllImport("user32")]
    public static extern IntPtr BeginPaint(IntPtr window, out PaintArea paint);

    [DllImport("user32")]
    public static extern bool EndPaint(IntPtr window, ref PaintArea paint);

    [DllImport("user32")]
    public static extern bool InvalidateRect(IntPtr window, IntPtr area, bool erase);

    [DllImport("user32")]
    public static extern bool UpdateWindow(IntPtr window);

    [DllImport("user32")]
    public static extern int GetSystemMetrics(int index);

    [DllImport("user32")]
    public static extern IntPtr SetThreadDpiAwarenessContext(IntPtr context);

    [DllImport("user32")]
    public static extern IntPtr GetThreadDpiAwarenessContext();

    [DllImport("user32")]
    public static extern uint GetDpiForSystem();

    [DllImport("user32")]
    public static extern int GetGuiResources(IntPtr process, uint kind);

    [DllImport("user32")]
    public static extern IntPtr GetDC(IntPtr window);

    [DllImport("user32")]
    public static extern int ReleaseDC(IntPtr window, IntPtr context);

    [DllImport("gdi32")]
    public static extern int GetPixel(IntPtr context, int x, int y);

    [DllImport("gdi32")]
    public static extern int SetDIBitsToDevice(
        IntPtr context,
        int x,
        int y,
        int width,
        int height,
        int sourceX,
        int sourceY,
        int firstRow,
        int rows,
        byte[] pixels,
        ref BitmapHeader header,
        uint usage
    );

    [StructLayout(LayoutKind.Sequential)]
    public struct WindowClass
    {
        public uint Style;
        public IntPtr Procedure;
        public int ClassExtra;
        public int WindowExtra;
        public IntPtr Module;
        public IntPtr Icon;
        public IntPtr Cursor;
        public IntPtr Background;
        public IntPtr MenuName;
        public IntPtr ClassName;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct Message
    {
        public IntPtr Window;
        public uint Id;
        public IntPtr Wide;
        public IntPtr Extra;
        public uint Time;
        public int X;
        public int Y;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct Rectangle
    {
        public int Left;
        public int Top;
        public int Right;
        public int Bottom;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct PaintArea
    {
        public IntPtr Context;
        public int Erase;
        public Rectangle Area;
        public int Restore;
        public int Update;

        [MarshalAs(UnmanagedType.ByValArray, SizeConst = 32)]
        public byte[] Reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct BitmapHeader
    {
        public int Size;
        public int Width;
        public int Height;
        public short Planes;
        public short BitCount;
        public int Compression;
        public int ImageSize;
        public int PixelsPerMetreX;
        public int PixelsPerMetreY;
        public int ColoursUsed;
        public int ColoursImportant;
    }
}
