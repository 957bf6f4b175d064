using SkiaSharp;

namespace Harvester.ImageLibraries;

internal sealed class SkiaLibrary : IImageLibrary
{
    public string Name => "SkiaSharp 4.155.0";

    public byte[] Decode(byte[] file)
    {
        using var data = SKData.CreateCopy(file);
        using SKCodec codec = SKCodec.Create(data) ?? throw new InvalidDataException("no codec");
        var info = new SKImageInfo(codec.Info.Width, codec.Info.Height, SKColorType.Rgba8888, SKAlphaType.Unpremul);
        byte[] rgba = new byte[info.BytesSize64];
        unsafe
        {
            fixed (byte* start = rgba)
            {
                if (codec.GetPixels(info, (nint)start) != SKCodecResult.Success)
                {
                    throw new InvalidDataException("not decoded");
                }
            }
        }

        byte[] pixels = new byte[rgba.Length / 4 * 3];
        for (int from = 0, to = 0; from < rgba.Length; from += 4, to += 3)
        {
            rgba.AsSpan(from, 3).CopyTo(pixels.AsSpan(to));
        }

        return pixels;
    }

    public bool IsRefusal(Exception exception) => exception is InvalidDataException;
}
