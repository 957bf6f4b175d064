using Harvester.Sessions.Files;

namespace Harvester.Datasets.Repair;

/// <summary>Corrects one flipped bit in a small file whose SHA-256 is known, by trying all.</summary>
internal static class BitRepair
{
    /// <summary>The largest file that is tried, bytes: 131,072 checksums of 16 KiB take a few seconds.</summary>
    public const int MaxBytes = 16 << 10;

    /// <summary>The file as it was written; null if more than one bit differs or the file is too large.</summary>
    /// <param name="damaged">The file as it is.</param>
    /// <param name="digests">What it may have been.</param>
    public static byte[]? Try(byte[] damaged, IReadOnlyList<FileDigest> digests)
    {
        if (damaged.Length > MaxBytes || digests.All(digest => digest.Bytes != damaged.Length))
        {
            return null;
        }

        byte[] tried = [.. damaged];
        for (int bit = 0; bit < tried.Length * 8; bit++)
        {
            byte mask = (byte)(1 << (bit % 8));
            tried[bit / 8] ^= mask;
            if (digests.Contains(FileDigest.Of(tried, tried.Length)))
            {
                return tried;
            }

            tried[bit / 8] ^= mask;
        }

        return null;
    }
}
