using System.Runtime.InteropServices;

namespace Harvester.Play.Screen.Windows;

/// <summary>RECT of windef.h.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct NativeRectangle
{
    public int Left;
    public int Top;
    public int Right;
    public int Bottom;

    public readonly DesktopRectangle ToPixels() => new(Left, Top, Right, Bottom);
}
