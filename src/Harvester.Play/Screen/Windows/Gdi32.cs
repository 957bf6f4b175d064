using System.Runtime.InteropServices;

namespace Harvester.Play.Screen.Windows;

/// <summary>Functions for copies of the screen, declared as in wingdi.h.</summary>
internal static class Gdi32
{
    public const int CopySource = 0x00CC0020;

    [DllImport("gdi32")]
    public static extern IntPtr CreateCompatibleDC(IntPtr context);

    [DllImport("gdi32")]
    [return: MarshalAs(UnmanagedType.Bool)]
    public static extern bool DeleteDC(IntPtr context);

    [DllImport("gdi32")]
    public static extern IntPtr CreateDIBSection(
        IntPtr context,
        ref NativeBitmapHeader header,
        uint usage,
        out IntPtr pixels,
        IntPtr section,
        uint offset
    );

    [DllImport("gdi32")]
    public static extern IntPtr SelectObject(IntPtr context, IntPtr handle);

    [DllImport("gdi32")]
    [return: MarshalAs(UnmanagedType.Bool)]
    public static extern bool DeleteObject(IntPtr handle);

    [DllImport("gdi32")]
    [return: MarshalAs(UnmanagedType.Bool)]
    public static extern bool BitBlt(
        IntPtr target,
        int x,
        int y,
        int width,
        int height,
        IntPtr source,
        int sourceX,
        int sourceY,
        int operation
    );

    [DllImport("gdi32")]
    [return: MarshalAs(UnmanagedType.Bool)]
    public static extern bool GdiFlush();
}
