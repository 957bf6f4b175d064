namespace Harvester.Sessions.Reading.Images.Jpeg;

/// <summary>A component of an image: luminance or a colour difference.</summary>
internal sealed class JpegComponent
{
    /// <summary>Width and height of a block, samples.</summary>
    public const int BlockSide = 8;

    /// <summary>Creates a component whose samples are not decoded yet.</summary>
    /// <param name="factors">Its blocks per MCU (minimum coded unit), horizontally and vertically.</param>
    /// <param name="units">MCUs of the image, horizontally and vertically.</param>
    public JpegComponent((int Across, int Down) factors, (int Across, int Down) units)
    {
        (Across, Down) = factors;
        Stride = units.Across * Across * BlockSide;
        Samples = new byte[Stride * units.Down * Down * BlockSide];
    }

    /// <summary>Horizontal number of blocks per MCU.</summary>
    public int Across { get; }

    /// <summary>Vertical number of blocks per MCU.</summary>
    public int Down { get; }

    /// <summary>Samples per row.</summary>
    public int Stride { get; }

    /// <summary>The samples, by rows from the top.</summary>
    public byte[] Samples { get; }

    /// <summary>The quantisation table, in zigzag order.</summary>
    public required int[] Quantisation { get; init; }

    /// <summary>The Huffman table of DC coefficients.</summary>
    public required JpegCode Dc { get; init; }

    /// <summary>The Huffman table of AC coefficients.</summary>
    public required JpegCode Ac { get; init; }
}
