namespace Harvester.Sessions.Imaging.Pictures;

/// <summary>
/// Writes Windows bitmaps: 24 bits per pixel, blue first, rows from the bottom, each padded to a multiple of four bytes. One encoder serves
/// one thread.
/// </summary>
public sealed class BmpEncoder
{
    private const int FileHeaderBytes = 14;
    private const int InfoHeaderBytes = 40;
    private const int HeaderBytes = FileHeaderBytes + InfoHeaderBytes;
    private byte[] _file = [];
    private int _width;

    /// <summary>Writes an image as a Windows bitmap.</summary>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    /// <exception cref="OverflowException">The file would be larger than 2 GiB.</exception>
    public void Write(PixelBuffer picture, Stream target)
    {
        if (picture is null)
        {
            throw new ArgumentNullException(nameof(picture));
        }

        if (target is null)
        {
            throw new ArgumentNullException(nameof(target));
        }

        int width = picture.Size.Width;
        int height = picture.Size.Height;

        // Rounded up to a multiple of four.
        int stride = ((width * PixelBuffer.BytesPerPixel) + 3) / 4 * 4;
        int length = checked(HeaderBytes + (stride * height));
        if (_file.Length != length || _width != width)
        {
            // A new one if only the width differs, too: the padding is at other positions.
            _file = new byte[length];
            _width = width;
        }

        WriteHeader(width, height, length);
        for (int row = 0; row < height; row++)
        {
            int from = row * width * PixelBuffer.BytesPerPixel;
            int to = HeaderBytes + ((height - 1 - row) * stride);
            for (int column = 0; column < width; column++, from += 3, to += 3)
            {
                _file[to] = picture.Bytes[from + 2];
                _file[to + 1] = picture.Bytes[from + 1];
                _file[to + 2] = picture.Bytes[from];
            }
        }

        target.Write(_file, 0, length);
    }

    private void WriteHeader(int width, int height, int length)
    {
        _file[0] = (byte)'B';
        _file[1] = (byte)'M';
        WriteLittleEndian(2, length);
        WriteLittleEndian(10, HeaderBytes);
        WriteLittleEndian(14, InfoHeaderBytes);
        WriteLittleEndian(18, width);
        WriteLittleEndian(22, height);
        _file[26] = 1; // planes
        _file[28] = PixelBuffer.BytesPerPixel * 8;
        WriteLittleEndian(34, length - HeaderBytes);
    }

    private void WriteLittleEndian(int offset, int value)
    {
        for (int i = 0; i < 4; i++)
        {
            _file[offset + i] = (byte)(value >> (8 * i));
        }
    }
}
