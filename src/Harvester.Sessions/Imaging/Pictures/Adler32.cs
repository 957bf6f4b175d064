#if !NET

namespace Harvester.Sessions.Imaging.Pictures;

/// <summary>The checksum of a zlib stream: RFC 1950, section 8.2.</summary>
internal sealed class Adler32
{
    private const uint Modulus = 65_521;

    /// <summary>Maximum number of bytes whose sums stay within 32 bits before they are reduced (zlib's NMAX).</summary>
    private const int MaxRunLength = 5_552;

    private uint _a = 1;
    private uint _b;

    public uint Value => (_b << 16) | _a;

    public void Append(byte[] bytes, int count)
    {
        uint a = _a;
        uint b = _b;
        for (int start = 0; start < count; start += MaxRunLength)
        {
            int end = Math.Min(count, start + MaxRunLength);
            for (int i = start; i < end; i++)
            {
                // a = 1 + Σ bytes, b = Σ of all a, both modulo 65521.
                a += bytes[i];
                b += a;
            }

            a %= Modulus;
            b %= Modulus;
        }

        _a = a;
        _b = b;
    }
}
#endif
