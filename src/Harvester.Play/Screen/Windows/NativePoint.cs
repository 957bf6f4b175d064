using System.Runtime.InteropServices;

namespace Harvester.Play.Screen.Windows;

/// <summary>POINT of windef.h.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct NativePoint
{
    public int X;
    public int Y;
}
