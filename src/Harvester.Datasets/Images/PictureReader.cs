using System.IO;
using Harvester.Datasets.Files;
using Harvester.Datasets.Images.Jpeg;
using Harvester.Sessions.Imaging;

namespace Harvester.Datasets.Images;

/// <summary>Reads the screenshots of sessions, whatever format they are kept in.</summary>
public static class PictureReader
{
    /// <summary>Reads a PNG, BMP or baseline JPEG picture in colour.</summary>
    /// <exception cref="DatasetFormatException">It is none of them, or damaged; the message speaks of the file as "it".</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static PixelBuffer Read(string path) => ImageHeader.Read(path).MediaType switch
    {
        ImageHeader.Jpeg => JpegDecoder.ReadRgb(path),
        ImageHeader.Bmp => BmpDecoder.ReadRgb(path),
        _ => PngDecoder.ReadRgb(path),
    };
}
