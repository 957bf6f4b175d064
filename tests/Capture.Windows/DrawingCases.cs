using System.Drawing;
using System.Drawing.Imaging;
using System.Runtime.InteropServices;
using Harvester.Play.Screen.Windows;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using ScreenshotFormat = Harvester.Sessions.Imaging.ImageFormat;

namespace Harvester.Capture.Windows;

/// <summary>Windows' own GDI+, through System.Drawing.Common, judges the grab and the encoders.</summary>
internal static class DrawingCases
{
    /// <summary>
    /// By how much a channel of a decoded JPEG may differ from the screenshot: at quality 95 no divisor is above 10, so a smooth picture
    /// loses about 5, and decoders round in their own ways.
    /// </summary>
    private const int MaxLoss = 8;

    public static IEnumerable<CaptureCase> All =>
        [
            new("a grab has the pixels that GDI+ copies from the screen", Grab),
            new("GDI+ reads the pixels of a PNG", () => Decoded(ScreenshotFormat.Png, maxLoss: 0)),
            new("GDI+ reads the pixels of a BMP", () => Decoded(ScreenshotFormat.Bmp, maxLoss: 0)),
            new("GDI+ reads the pixels of a JPEG, nearly", () => Decoded(ScreenshotFormat.Jpeg, MaxLoss)),
        ];

    private static void Grab()
    {
        using var window = new PatternWindow(new(75, 45, 401, 301), Pattern.Distinct(12));
        window.AwaitOnScreen();
        using var screen = GameWindowScreen.OfThisProcess();
        var buffer = new PixelBuffer(new(window.Client.Width, window.Client.Height));
        Expect.Good(screen.Grab(buffer));
        using Bitmap copy = CopyFromScreen(window.Client);
        ExpectSame(buffer.Bytes, Pixels(copy), maxLoss: 0);
    }

    private static void Decoded(ScreenshotFormat format, int maxLoss)
    {
        PixelBuffer picture = Smooth();
        using var file = new MemoryStream();
        new PictureEncoder(format).Write(picture, file);
        file.Position = 0;
        using var bitmap = new Bitmap(file);
        Expect.That(
            bitmap.Width == picture.Size.Width && bitmap.Height == picture.Size.Height,
            $"GDI+ reads {bitmap.Width} x {bitmap.Height}"
        );
        ExpectSame(picture.Bytes, Pixels(bitmap), maxLoss);
    }

    private static Bitmap CopyFromScreen(Area area)
    {
        using var pixels = PhysicalThread.Enter();
        var bitmap = new Bitmap(area.Width, area.Height, PixelFormat.Format24bppRgb);
        using Graphics graphics = Graphics.FromImage(bitmap);
        graphics.CopyFromScreen(area.Left, area.Top, 0, 0, bitmap.Size);
        return bitmap;
    }

    /// <summary>Slopes of each colour in another direction; no side is a multiple of a block's.</summary>
    private static PixelBuffer Smooth()
    {
        var picture = new PixelBuffer(new(203, 149));
        for (int y = 0, at = 0; y < picture.Size.Height; y++)
        {
            for (int x = 0; x < picture.Size.Width; x++)
            {
                picture.Bytes[at++] = (byte)x;
                picture.Bytes[at++] = (byte)y;
                picture.Bytes[at++] = (byte)(255 - ((x + y) / 2));
            }
        }

        return picture;
    }

    /// <summary>The pixels of a bitmap as a screenshot has them.</summary>
    private static byte[] Pixels(Bitmap bitmap)
    {
        BitmapData data = bitmap.LockBits(new Rectangle(Point.Empty, bitmap.Size), ImageLockMode.ReadOnly, PixelFormat.Format24bppRgb);
        byte[] pixels = new byte[bitmap.Width * bitmap.Height * PixelBuffer.BytesPerPixel];
        for (int y = 0, at = 0; y < bitmap.Height; y++)
        {
            for (int x = 0; x < bitmap.Width; x++)
            {
                // GDI+ keeps blue first.
                for (int channel = PixelBuffer.BytesPerPixel - 1; channel >= 0; channel--)
                {
                    pixels[at++] = Marshal.ReadByte(data.Scan0, (y * data.Stride) + (x * PixelBuffer.BytesPerPixel) + channel);
                }
            }
        }

        bitmap.UnlockBits(data);
        return pixels;
    }

    private static void ExpectSame(byte[] expected, byte[] actual, int maxLoss)
    {
        for (int i = 0; i < expected.Length; i++)
        {
            Expect.That(Math.Abs(expected[i] - actual[i]) <= maxLoss, $"byte {i} is {actual[i]}, expected {expected[i]}");
        }
    }
}
