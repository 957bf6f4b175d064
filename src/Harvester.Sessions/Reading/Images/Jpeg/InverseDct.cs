namespace Harvester.Sessions.Reading.Images.Jpeg;

/// <summary>
/// The inverse discrete cosine transform of a block after Loeffler, Ligtenberg and Moschytz (1989), with 13 fractional bits, as in
/// libjpeg's "islow"; the samples equal libjpeg's.
/// </summary>
internal static class InverseDct
{
    private const int Side = JpegComponent.BlockSide;
    private const int FractionBits = 13;
    private const int KeptBits = 2;

    /// <summary>The factor of 8 in the transform.</summary>
    private const int ScaleBits = 3;

    // Round(c * 2^13); the names are libjpeg's.
    private const int Fix0298631336 = 2446;
    private const int Fix0390180644 = 3196;
    private const int Fix0541196100 = 4433;
    private const int Fix0765366865 = 6270;
    private const int Fix0899976223 = 7373;
    private const int Fix1175875602 = 9633;
    private const int Fix1501321110 = 12299;
    private const int Fix1847759065 = 15137;
    private const int Fix1961570560 = 16069;
    private const int Fix2053119869 = 16819;
    private const int Fix2562915447 = 20995;
    private const int Fix3072711026 = 25172;

    /// <summary>Transforms a block.</summary>
    /// <param name="block">Its 64 coefficients, by rows; overwritten.</param>
    /// <param name="samples">Receives the samples.</param>
    /// <param name="start">Index of the first sample.</param>
    /// <param name="stride">Distance of rows in the samples.</param>
    public static void Transform(Span<int> block, byte[] samples, int start, int stride)
    {
        for (int column = 0; column < Side; column++)
        {
            Pass(block[column..], Side, FractionBits - KeptBits);
        }

        for (int row = 0; row < Side; row++)
        {
            Span<int> values = block.Slice(row * Side, Side);
            Pass(values, 1, FractionBits + KeptBits + ScaleBits);
            for (int column = 0; column < Side; column++)
            {
                samples[start + (row * stride) + column] = (byte)Math.Clamp(values[column] + 128, 0, 255);
            }
        }
    }

    private static void Pass(Span<int> values, int step, int bits)
    {
        int turned = (values[2 * step] + values[6 * step]) * Fix0541196100;
        int evenLow = turned - (values[6 * step] * Fix1847759065);
        int evenHigh = turned + (values[2 * step] * Fix0765366865);
        int sum = (values[0] + values[4 * step]) << FractionBits;
        int difference = (values[0] - values[4 * step]) << FractionBits;

        int a = values[7 * step];
        int b = values[5 * step];
        int c = values[3 * step];
        int d = values[step];
        int all = (a + c + b + d) * Fix1175875602;
        int ad = (a + d) * Fix0899976223;
        int bc = (b + c) * Fix2562915447;
        int ac = all - ((a + c) * Fix1961570560);
        int bd = all - ((b + d) * Fix0390180644);
        Place(values, step, 0, sum + evenHigh, (d * Fix1501321110) - ad + bd, bits);
        Place(values, step, 1, difference + evenLow, (c * Fix3072711026) - bc + ac, bits);
        Place(values, step, 2, difference - evenLow, (b * Fix2053119869) - bc + bd, bits);
        Place(values, step, 3, sum - evenHigh, (a * Fix0298631336) - ad + ac, bits);
    }

    /// <summary>A value and its mirror image, rounded.</summary>
    private static void Place(Span<int> values, int step, int index, int even, int odd, int bits)
    {
        int half = 1 << (bits - 1);
        values[index * step] = (even + odd + half) >> bits;
        values[(Side - 1 - index) * step] = (even - odd + half) >> bits;
    }
}
