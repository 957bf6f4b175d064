namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>Shares of red, green and blue in Y, Cb and Cr after JFIF 1.02 (ITU-R BT.601, full range), with 16 bits of fraction.</summary>
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

    /// <summary>Of blue in Cb and of red in Cr.</summary>
    public const int Half = 32_768;

    /// <summary>Rounds Y.</summary>
    public const int RoundingOfY = 1 << (Bits - 1);

    /// <summary>Rounds Cb and Cr, a little less than half, so that full blue and full red stay below 128.</summary>
    public const int RoundingOfColour = RoundingOfY - 1;

    /// <summary>Y is 0 to 255; the transform takes values around 0, as Cb and Cr are.</summary>
    public const int LevelShift = 128;
}
