using System.Runtime.InteropServices;

namespace Harvester.Play.Screen.Windows;

/// <summary>BITMAPINFOHEADER of wingdi.h.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct NativeBitmapHeader
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
