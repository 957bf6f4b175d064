using SixLabors.ImageSharp;
using SixLabors.ImageSharp.PixelFormats;

namespace Harvester.ImageLibraries;

internal sealed class ImageSharpLibrary : IImageLibrary
{
    public string Name => "ImageSharp 2.1.13";

    public byte[] Decode(byte[] file)
    {
        using Image<Rgb24> image = Image.Load<Rgb24>(file);
        byte[] pixels = new byte[3 * image.Width * image.Height];
        image.CopyPixelDataTo(pixels);
        return pixels;
    }

    public bool IsRefusal(Exception exception) =>
        exception is ImageFormatException or SixLabors.ImageSharp.Memory.InvalidMemoryOperationException;
}
