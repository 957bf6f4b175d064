namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>The divisors of a block's coefficients, rows from the top: T.81, annex K.1, scaled to a quality as in libjpeg.</summary>
internal sealed class QuantisationTable
{
    /// <summary>Factor between the transform's results and the coefficients.</summary>
    private const int TransformScale = 8;

    /// <summary>Results of the transform and half a divisor stay below 2 to this power.</summary>
    private const int DividendBits = 14;

    private static readonly byte[] LumaAt50 =
    [
        16,
        11,
        10,
        16,
        24,
        40,
        51,
        61,
        12,
        12,
        14,
        19,
        26,
        58,
        60,
        55,
        14,
        13,
        16,
        24,
        40,
        57,
        69,
        56,
        14,
        17,
        22,
        29,
        51,
        87,
        80,
        62,
        18,
        22,
        37,
        56,
        68,
        109,
        103,
        77,
        24,
        35,
        55,
        64,
        81,
        104,
        113,
        92,
        49,
        64,
        78,
        87,
        103,
        121,
        120,
        101,
        72,
        92,
        95,
        98,
        112,
        100,
        103,
        99,
    ];

    private static readonly byte[] ChromaAt50 =
    [
        17,
        18,
        24,
        47,
        99,
        99,
        99,
        99,
        18,
        21,
        26,
        66,
        99,
        99,
        99,
        99,
        24,
        26,
        56,
        99,
        99,
        99,
        99,
        99,
        47,
        66,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
        99,
    ];

    private QuantisationTable(byte[] at50, int quality)
    {
        // libjpeg's scale: 100 % at quality 50, 2 % a step less above, 5000 / quality below.
        int percent = quality < 50 ? 5000 / quality : 200 - (2 * quality);
        for (int i = 0; i < JpegBlock.Length; i++)
        {
            Divisors[i] = (byte)Math.Max(1, Math.Min(255, ((at50[i] * percent) + 50) / 100));

            // Division by a multiplication and a shift, exact over the range of the dividends.
            int divisor = Divisors[i] * TransformScale;
            int bits = 1;
            while (1 << bits < divisor)
            {
                bits++;
            }

            // With n < 2^14 and 2^s >= 2^14 * divisor, n * ceil(2^s / divisor) >> s is the integer part of n / divisor.
            Shifts[i] = DividendBits + bits;
            Multipliers[i] = ((1 << Shifts[i]) + divisor - 1) / divisor;
            Halves[i] = divisor / 2;
        }
    }

    /// <summary>The divisors as stored in the file, 1 to 255.</summary>
    public byte[] Divisors { get; } = new byte[JpegBlock.Length];

    /// <summary>Added to a magnitude to round the quotient.</summary>
    public int[] Halves { get; } = new int[JpegBlock.Length];

    /// <summary>Factor on a magnitude before it is shifted.</summary>
    public int[] Multipliers { get; } = new int[JpegBlock.Length];

    /// <summary>Number of bits by which the product is shifted to the right.</summary>
    public int[] Shifts { get; } = new int[JpegBlock.Length];

    /// <summary>The table for Y at a quality, 1 to 100.</summary>
    public static QuantisationTable Luma(int quality) => new(LumaAt50, quality);

    /// <summary>The table for Cb and Cr at a quality, 1 to 100.</summary>
    public static QuantisationTable Chroma(int quality) => new(ChromaAt50, quality);
}
