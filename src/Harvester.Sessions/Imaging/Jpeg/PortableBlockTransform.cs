namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>The transform in single integers: for runtimes and machines without vectors.</summary>
internal sealed class PortableBlockTransform : BlockTransform
{
    private readonly QuantisationTable _luma;
    private readonly QuantisationTable _chroma;

    public PortableBlockTransform(QuantisationTable luma, QuantisationTable chroma)
    {
        _luma = luma;
        _chroma = chroma;
    }

    protected override void Transform(byte[] pixels, int start, int stride, QuantisedBlocks blocks)
    {
        int[] coefficients = blocks.Coefficients;
        ReadColours(pixels, start, stride, coefficients);
        for (int component = 0; component < JpegBlock.Components; component++)
        {
            int block = component * JpegBlock.Length;
            for (int row = 0; row < JpegBlock.Side; row++)
            {
                ForwardDct<int, IntegerLane>.FirstPass(coefficients, block + (row * JpegBlock.Side), 1);
            }

            for (int column = 0; column < JpegBlock.Side; column++)
            {
                ForwardDct<int, IntegerLane>.SecondPass(coefficients, block + column, JpegBlock.Side);
            }

            blocks.Present[component] = Divide(coefficients, block, component == 0 ? _luma : _chroma);
        }
    }

    private static void ReadColours(byte[] pixels, int start, int stride, int[] target)
    {
        for (int y = 0, at = 0; y < JpegBlock.Side; y++)
        {
            int from = start + (y * stride);
            for (int x = 0; x < JpegBlock.Side; x++, at++, from += PixelBuffer.BytesPerPixel)
            {
                int red = pixels[from];
                int green = pixels[from + 1];
                int blue = pixels[from + 2];
                target[at] =
                    (
                        (
                            (ColourWeights.RedInY * red)
                            + (ColourWeights.GreenInY * green)
                            + (ColourWeights.BlueInY * blue)
                            + ColourWeights.RoundingOfY
                        ) >> ColourWeights.Bits
                    ) - ColourWeights.LevelShift;
                target[at + JpegBlock.Length] =
                    (
                        (ColourWeights.RedInCb * red)
                        + (ColourWeights.GreenInCb * green)
                        + (ColourWeights.Half * blue)
                        + ColourWeights.RoundingOfColour
                    ) >> ColourWeights.Bits;
                target[at + (2 * JpegBlock.Length)] =
                    (
                        (ColourWeights.Half * red)
                        + (ColourWeights.GreenInCr * green)
                        + (ColourWeights.BlueInCr * blue)
                        + ColourWeights.RoundingOfColour
                    ) >> ColourWeights.Bits;
            }
        }
    }

    /// <returns>A bit for each quotient that is not 0.</returns>
    private static ulong Divide(int[] values, int start, QuantisationTable table)
    {
        ulong present = 0;
        for (int i = 0; i < JpegBlock.Length; i++)
        {
            int value = values[start + i];

            // Rounded division of the magnitude, (|value| + divisor / 2) / divisor, then the sign again: value ^ sign - sign negates where
            // sign is -1.
            int sign = value >> 31;
            int quotient = ((((value ^ sign) - sign) + table.Halves[i]) * table.Multipliers[i]) >> table.Shifts[i];
            values[start + i] = (quotient ^ sign) - sign;
            present |= (ulong)((uint)-quotient >> 31) << i;
        }

        return present;
    }
}
