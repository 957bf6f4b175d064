using Harvester.Sessions.Imaging;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images.Jpeg;

namespace Harvester.Sessions.Reading.Images;

/// <summary>Reads the images of sessions, in any of their formats.</summary>
public static class PictureReader
{
    /// <summary>Reads a colour PNG, BMP or baseline JPEG image.</summary>
    /// <exception cref="DatasetFormatException">The file has another format, or is damaged; the message refers to the file as
    /// "it".</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static PixelBuffer Read(string path) =>
        ImageHeader.Read(path).MediaType switch
        {
            ImageHeader.Jpeg => JpegDecoder.ReadRgb(path),
            ImageHeader.Bmp => BmpDecoder.ReadRgb(path),
            _ => PngDecoder.ReadRgb(path),
        };
}
