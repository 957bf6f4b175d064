namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>A block in its three components as stored in the file: rounded quotients of coefficients and divisors.</summary>
internal sealed class QuantisedBlocks
{
    /// <summary>
    /// The coefficients of Y, then those of Cb and Cr, each rows from the top; those that are not <see cref="Present"/> are 0.
    /// </summary>
    public int[] Coefficients { get; } = new int[JpegBlock.Components * JpegBlock.Length];

    /// <summary>Of Y, Cb and Cr: a bit for each coefficient that is not 0, the first in the lowest.</summary>
    public ulong[] Present { get; } = new ulong[JpegBlock.Components];
}
