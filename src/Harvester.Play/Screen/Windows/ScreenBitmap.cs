using System.ComponentModel;
using System.Runtime.InteropServices;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.Play.Screen.Windows;

/// <summary>
/// A reused bitmap in memory into which GDI copies the screen: 4 bytes per pixel, blue, green, red, unused, rows from the top.
/// </summary>
internal sealed class ScreenBitmap : IDisposable
{
    private const int BytesPerPixel = 4;
    private readonly IntPtr _context;
    private readonly IntPtr _bitmap;
    private readonly IntPtr _replaced;
    private readonly IntPtr _pixels;
    private readonly byte[] _row;

    public ScreenBitmap(ImageSize size)
    {
        Size = size;
        _row = new byte[size.Width * BytesPerPixel];
        var header = new NativeBitmapHeader
        {
            Size = Marshal.SizeOf<NativeBitmapHeader>(),
            Width = size.Width,
            Height = -size.Height,
            Planes = 1,
            BitCount = BytesPerPixel * 8,
        };
        _context = Gdi32.CreateCompatibleDC(IntPtr.Zero);
        _bitmap = Gdi32.CreateDIBSection(_context, ref header, 0, out _pixels, IntPtr.Zero, 0);
        if (_bitmap == IntPtr.Zero)
        {
            Gdi32.DeleteDC(_context);
            throw new Win32Exception($"Windows has no memory for a bitmap of {size.Width}x{size.Height} pixels.");
        }

        _replaced = Gdi32.SelectObject(_context, _bitmap);
    }

    public ImageSize Size { get; }

    /// <summary>Copies a rectangle of the screen into this bitmap; false if the screen cannot be read.</summary>
    public bool TryCopyScreen(int left, int top)
    {
        IntPtr screen = User32.GetDC(IntPtr.Zero);
        if (screen == IntPtr.Zero)
        {
            return false;
        }

        bool isCopied = Gdi32.BitBlt(_context, 0, 0, Size.Width, Size.Height, screen, left, top, Gdi32.CopySource);
        _ = User32.ReleaseDC(IntPtr.Zero, screen);
        Gdi32.GdiFlush();
        return isCopied;
    }

    /// <summary>Copies the pixels into a <see cref="PixelBuffer"/> of the same size.</summary>
    public void ReadInto(PixelBuffer target)
    {
        byte[] bytes = target.Bytes;
        int to = 0;
        for (int y = 0; y < Size.Height; y++)
        {
            Marshal.Copy(IntPtr.Add(_pixels, y * _row.Length), _row, 0, _row.Length);
            for (int from = 0; from < _row.Length; from += BytesPerPixel)
            {
                bytes[to++] = _row[from + 2];
                bytes[to++] = _row[from + 1];
                bytes[to++] = _row[from];
            }
        }
    }

    public void Dispose()
    {
        Gdi32.SelectObject(_context, _replaced);
        Gdi32.DeleteObject(_bitmap);
        Gdi32.DeleteDC(_context);
    }
}
