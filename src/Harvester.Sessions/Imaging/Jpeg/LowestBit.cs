namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>Finds the lowest bit that is set.</summary>
internal static class LowestBit
{
#if NET
    /// <summary>Index of the lowest set bit, 0 to 63; the bits are not all 0.</summary>
    public static int Of(ulong bits) => System.Numerics.BitOperations.TrailingZeroCount(bits);
#else
    /// <summary>A de Bruijn sequence: its upper six bits differ at each of the 64 shifts.</summary>
    private const ulong Sequence = 0x03F79D71B4CB0A89;
    private static readonly byte[] Places = MakePlaces();

    /// <summary>Index of the lowest set bit, 0 to 63; the bits are not all 0.</summary>
    public static int Of(ulong bits) => Places[((bits & (~bits + 1)) * Sequence) >> 58];

    private static byte[] MakePlaces()
    {
        byte[] places = new byte[64];
        for (int place = 0; place < places.Length; place++)
        {
            places[(Sequence << place) >> 58] = (byte)place;
        }

        return places;
    }
#endif
}
