using System.Runtime.InteropServices;

namespace Harvester.Play.Screen.Windows;

/// <summary>WINDOWPLACEMENT of winuser.h.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct NativePlacement
{
    public int Length;
    public int Flags;
    public int ShowCommand;
    public NativePoint MinimisedAt;
    public NativePoint MaximisedAt;
    public NativeRectangle Normal;
}
