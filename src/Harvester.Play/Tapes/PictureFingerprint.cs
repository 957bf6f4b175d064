namespace Harvester.Play.Tapes;

/// <summary>A fingerprint of pictures that is fast enough for the game's thread. It protects against chance, not against intent.</summary>
internal static class PictureFingerprint
{
    // FNV-1a with 64 bits, applied to words of 8 bytes instead of single bytes, and mixed so that high bits reach the low ones.
    private const ulong Offset = 14695981039346656037;
    private const ulong Prime = 1099511628211;
    private const int WordBytes = sizeof(ulong);
    private const int Mixing = 29;

    public static ulong Of(byte[] bytes)
    {
        ulong hash = Offset;
        int i = 0;
        for (; i + WordBytes <= bytes.Length; i += WordBytes)
        {
            hash = Mixed(hash ^ BitConverter.ToUInt64(bytes, i));
        }

        for (; i < bytes.Length; i++)
        {
            hash = Mixed(hash ^ bytes[i]);
        }

        return hash;
    }

    private static ulong Mixed(ulong hash)
    {
        hash = unchecked(hash * Prime);
        return hash ^ (hash >> Mixing);
    }
}
