namespace Harvester.Datasets.Images.Jpeg;

/// <summary>One of a picture's components, brightness or a colour difference.</summary>
internal sealed class JpegComponent
{
    /// <summary>Samples of a block's side.</summary>
    public const int BlockSide = 8;

    /// <summary>Makes a component whose samples are not decoded yet.</summary>
    /// <param name="factors">Its blocks in a unit of the scan, across and down.</param>
    /// <param name="units">Units of the picture, across and down.</param>
    public JpegComponent((int Across, int Down) factors, (int Across, int Down) units)
    {
        (Across, Down) = factors;
        Stride = units.Across * Across * BlockSide;
        Samples = new byte[Stride * units.Down * Down * BlockSide];
    }

    /// <summary>Its blocks in a unit of the scan from left to right.</summary>
    public int Across { get; }

    /// <summary>The same from top to bottom.</summary>
    public int Down { get; }

    /// <summary>Samples of a row.</summary>
    public int Stride { get; }

    /// <summary>The samples, row by row from the top.</summary>
    public byte[] Samples { get; }

    /// <summary>The divisors of its coefficients, in the file's order.</summary>
    public required int[] Quantisation { get; init; }

    /// <summary>The codes of its first coefficients.</summary>
    public required JpegCode Dc { get; init; }

    /// <summary>The codes of its other coefficients.</summary>
    public required JpegCode Ac { get; init; }
}
