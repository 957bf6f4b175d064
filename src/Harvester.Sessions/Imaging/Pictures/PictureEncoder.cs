using Harvester.Sessions.Imaging.Jpeg;

namespace Harvester.Sessions.Imaging.Pictures;

/// <summary>Writes images in a chosen format. One encoder serves one thread; its buffers are reused.</summary>
public sealed class PictureEncoder
{
    private readonly Action<PixelBuffer, Stream> _write;

    /// <summary>Creates an encoder for one format.</summary>
    /// <param name="format">The format of the files.</param>
    /// <param name="jpegQuality">The quality of JPEG files, 1 to 100; ignored for other formats.</param>
    /// <exception cref="ArgumentOutOfRangeException">The quality is out of its range, or the format does not exist.</exception>
    public PictureEncoder(ImageFormat format, int jpegQuality = JpegEncoder.DefaultQuality)
    {
        _write = format switch
        {
            ImageFormat.Png => new PngEncoder().Write,
            ImageFormat.Bmp => new BmpEncoder().Write,
            ImageFormat.Jpeg => new JpegEncoder(jpegQuality).Write,
            _ => throw new ArgumentOutOfRangeException(nameof(format), format, null),
        };
    }

    /// <summary>Writes an image in the format of the encoder.</summary>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void Write(PixelBuffer picture, Stream target) => _write(picture, target);
}
