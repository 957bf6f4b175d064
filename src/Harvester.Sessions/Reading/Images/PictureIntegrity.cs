using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading.Images;

/// <summary>Decodes pictures to see whether they are whole.</summary>
internal static class PictureIntegrity
{
    /// <summary>The largest picture of which several may be in memory at once, pixels.</summary>
    private const int ManyPixels = 1 << 24;

    private static readonly Lock Large = new();

    /// <summary>Checks a PNG, BMP or JPEG file. JPEG and BMP have no checksums: what still decodes passes.</summary>
    /// <exception cref="DatasetFormatException">The file is damaged; the message refers to it as "it".</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static void Check(string path)
    {
        ImageHeader header = ImageHeader.Read(path);
        if (header.MediaType == ImageHeader.Png)
        {
            PngIntegrity.Check(path);
        }
        else if (header.Size.PixelCount <= ManyPixels)
        {
            _ = PictureReader.Read(path);
        }
        else
        {
            lock (Large)
            {
                _ = PictureReader.Read(path);
            }
        }
    }
}
