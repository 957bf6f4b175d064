using System.Buffers.Binary;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading.Images;

/// <summary>Reads Windows bitmaps of the kind in sessions: 24 bits per pixel, uncompressed, bottom-up or top-down.</summary>
public static class BmpDecoder
{
    private const int PixelsStartAt = 10;
    private const int HeightAt = 22;
    private const int BitsAt = 28;
    private const int CompressionAt = 30;
    private const int HeaderLength = 34;

    /// <summary>Reads an image.</summary>
    /// <exception cref="DatasetFormatException">The file is not such an image, or is damaged; the message refers to the file as
    /// "it".</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static PixelBuffer ReadRgb(string path)
    {
        var picture = new PixelBuffer(ImageHeader.Read(path).Size);
        byte[] file = InputFile.ReadAllBytes(path, InputFile.MaxPictureBytes);
        if (
            file.Length < HeaderLength
            || BinaryPrimitives.ReadUInt16LittleEndian(file.AsSpan(BitsAt)) != 24
            || BinaryPrimitives.ReadInt32LittleEndian(file.AsSpan(CompressionAt)) != 0
        )
        {
            throw new DatasetFormatException("it is not a BMP of 24 bits without compression.");
        }

        int width = picture.Size.Width;
        int height = picture.Size.Height;
        long start = BinaryPrimitives.ReadUInt32LittleEndian(file.AsSpan(PixelsStartAt));
        long stride = ((width * PixelBuffer.BytesPerPixel) + 3) / 4 * 4;
        if (start + (stride * height) > file.Length)
        {
            throw new DatasetFormatException("its pixels are cut off.");
        }

        bool isFromTop = BinaryPrimitives.ReadInt32LittleEndian(file.AsSpan(HeightAt)) < 0;
        for (int row = 0, to = 0; row < height; row++)
        {
            int from = (int)(start + (stride * (isFromTop ? row : height - 1 - row)));
            for (int column = 0; column < width; column++, from += PixelBuffer.BytesPerPixel, to += PixelBuffer.BytesPerPixel)
            {
                picture.Bytes[to] = file[from + 2];
                picture.Bytes[to + 1] = file[from + 1];
                picture.Bytes[to + 2] = file[from];
            }
        }

        return picture;
    }
}
