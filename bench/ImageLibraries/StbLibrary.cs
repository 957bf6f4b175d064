using StbImageSharp;

namespace Harvester.ImageLibraries;

internal sealed class StbLibrary : IImageLibrary
{
    public string Name => "StbImageSharp 2.30.16";

    public byte[] Decode(byte[] file) => ImageResult.FromMemory(file, ColorComponents.RedGreenBlue).Data;

    // It throws exceptions of the base class, with a word of stb_image as the message.
    public bool IsRefusal(Exception exception) =>
        exception.GetType() == typeof(InvalidOperationException) || exception.GetType() == typeof(Exception);
}
