using System.Buffers.Binary;
using System.IO.Compression;
using System.Text;

namespace Harvester.TestSupport;

/// <summary>
/// Reads a PNG by the standard's text, with all five filters and every checksum checked; it shares nothing with the encoder.
/// </summary>
internal sealed class TestPngDecoder
{
    private TestPngDecoder(int width, int height, int bits, int colourType, byte[] samples)
    {
        Width = width;
        Height = height;
        Bits = bits;
        ColourType = colourType;
        Samples = samples;
    }

    public int Width { get; }

    public int Height { get; }

    public int Bits { get; }

    public int ColourType { get; }

    /// <summary>Rows from the top, without filter bytes; 16-bit samples high byte first.</summary>
    public byte[] Samples { get; }

    public static TestPngDecoder Decode(byte[] file)
    {
        Assert.Equal([0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A], file[..8]);
        byte[] header = [];
        var data = new MemoryStream();
        string type = "";
        for (int at = 8; type != "IEND"; )
        {
            int length = (int)BinaryPrimitives.ReadUInt32BigEndian(file.AsSpan(at));
            type = Encoding.ASCII.GetString(file, at + 4, 4);
            byte[] body = file[(at + 8)..(at + 8 + length)];
            uint stated = BinaryPrimitives.ReadUInt32BigEndian(file.AsSpan(at + 8 + length));
            Assert.Equal(Crc(file[(at + 4)..(at + 8 + length)]), stated);
            at += 12 + length;
            header = type == "IHDR" ? body : header;
            data.Write(type == "IDAT" ? body : []);
            Assert.True(type != "IEND" || at == file.Length, "Something follows the end.");
        }

        int width = (int)BinaryPrimitives.ReadUInt32BigEndian(header);
        int height = (int)BinaryPrimitives.ReadUInt32BigEndian(header.AsSpan(4));
        int pixelBytes =
            header[9] switch
            {
                0 => 1,
                2 => 3,
                var other => throw new InvalidDataException($"Colour type {other}."),
            }
            * header[8]
            / 8;
        Assert.Equal([0, 0, 0], header[10..]);
        var inflated = new MemoryStream();
        data.Position = 0;
        // ZLibStream checks the Adler-32 trailer by itself.
        using (var zlib = new ZLibStream(data, CompressionMode.Decompress))
        {
            zlib.CopyTo(inflated);
        }

        return new TestPngDecoder(
            width,
            height,
            header[8],
            header[9],
            Unfilter(inflated.ToArray(), width * pixelBytes, height, pixelBytes)
        );
    }

    private static byte[] Unfilter(byte[] filtered, int stride, int rows, int pixelBytes)
    {
        Assert.Equal(rows * (stride + 1), filtered.Length);
        byte[] samples = new byte[rows * stride];
        for (int row = 0; row < rows; row++)
        {
            for (int i = 0; i < stride; i++)
            {
                int left = i < pixelBytes ? 0 : samples[(row * stride) + i - pixelBytes];
                int up = row == 0 ? 0 : samples[((row - 1) * stride) + i];
                int corner = row == 0 || i < pixelBytes ? 0 : samples[((row - 1) * stride) + i - pixelBytes];
                int predicted = filtered[row * (stride + 1)] switch
                {
                    0 => 0,
                    1 => left,
                    2 => up,
                    3 => (left + up) / 2,
                    4 => Paeth(left, up, corner),
                    var other => throw new InvalidDataException($"Filter {other}."),
                };
                samples[(row * stride) + i] = (byte)(filtered[(row * (stride + 1)) + 1 + i] + predicted);
            }
        }

        return samples;
    }

    private static int Paeth(int left, int up, int corner)
    {
        int estimate = left + up - corner;
        int toLeft = Math.Abs(estimate - left),
            toUp = Math.Abs(estimate - up),
            toCorner = Math.Abs(estimate - corner);
        return toLeft <= toUp && toLeft <= toCorner ? left
            : toUp <= toCorner ? up
            : corner;
    }

    /// <summary>The standard's annex D, bit by bit.</summary>
    private static uint Crc(byte[] bytes)
    {
        uint crc = 0xFFFFFFFF;
        foreach (byte value in bytes)
        {
            crc ^= value;
            for (int bit = 0; bit < 8; bit++)
            {
                crc = (crc & 1) != 0 ? 0xEDB88320 ^ (crc >> 1) : crc >> 1;
            }
        }

        return ~crc;
    }
}
