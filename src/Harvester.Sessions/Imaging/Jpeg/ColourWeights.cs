namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>
/// Weights of red, green and blue in Y, Cb and Cr according to JFIF 1.02 (ITU-R BT.601, full range), with 16 fractional bits.
/// </summary>
internal static class ColourWeights
{
    public const int Bits = 16;

    // Round(0.299 * 2^16) and so on.
    public const int RedInY = 19_595;
    public const int GreenInY = 38_470;
    public const int BlueInY = 7_471;
    public const int RedInCb = -11_059;
    public const int GreenInCb = -21_709;
    public const int GreenInCr = -27_439;
    public const int BlueInCr = -5_329;

    /// <summary>Weight of blue in Cb and of red in Cr.</summary>
    public const int Half = 32_768;

    /// <summary>Added to round Y.</summary>
    public const int RoundingOfY = 1 << (Bits - 1);

    /// <summary>Added to round Cb and Cr; a little less than half, so that full blue and full red stay below 128.</summary>
    public const int RoundingOfColour = RoundingOfY - 1;

    /// <summary>Y is 0 to 255; the transform takes values around 0, as Cb and Cr are.</summary>
    public const int LevelShift = 128;
}
