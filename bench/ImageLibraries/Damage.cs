using System.Diagnostics;

namespace Harvester.ImageLibraries;

/// <summary>
/// Decodes damaged copies of a file: one to three flipped bits, an end that is missing, or a declared size of 60,000 by 60,000.
/// </summary>
internal static class Damage
{
    private const long Gigabyte = 1L << 30;

    /// <summary>What became of the copies.</summary>
    /// <param name="library">The library.</param>
    /// <param name="file">The file.</param>
    /// <param name="count">Number of copies.</param>
    /// <param name="seed">Seed of the damage.</param>
    public static DamageCount Count(IImageLibrary library, byte[] file, int count, int seed)
    {
        byte[] whole = library.Decode(file);
        var random = new Random(seed);
        var counted = new DamageCount();
        for (int i = 0; i < count; i++)
        {
            byte[] copy = Damaged(file, random, i);
            long before = GC.GetTotalAllocatedBytes();
            long started = Stopwatch.GetTimestamp();
            try
            {
                counted.Unnoticed += library.Decode(copy).AsSpan().SequenceEqual(whole) ? 0 : 1;
            }
            catch (Exception e) when (library.IsRefusal(e))
            {
                counted.Refused++;
            }
            catch (Exception)
            {
                counted.OtherExceptions++;
            }

            counted.Slow += Stopwatch.GetElapsedTime(started).TotalSeconds > 1 ? 1 : 0;
            counted.Large += GC.GetTotalAllocatedBytes() - before > Gigabyte ? 1 : 0;
        }

        return counted;
    }

    private static byte[] Damaged(byte[] file, Random random, int i)
    {
        byte[] copy = [.. file];
        if (i % 10 == 0)
        {
            return copy[..random.Next(1, copy.Length)];
        }

        if (i == 1)
        {
            // The lower halves of width and height: in a PNG from byte 16 on, in a JPEG after length and precision of its SOF0 segment.
            int at = copy[0] == 0x89 ? 18 : copy.AsSpan().IndexOf<byte>([0xFF, 0xC0]) + 5;
            (copy[at], copy[at + 1]) = (0xEA, 0x60);
            int next = copy[0] == 0x89 ? 22 : at + 2;
            (copy[next], copy[next + 1]) = (0xEA, 0x60);
            return copy;
        }

        for (int flips = random.Next(1, 4); flips > 0; flips--)
        {
            // Half of the flips are in the first kilobyte, where the headers are.
            int at = random.Next(random.Next(2) == 0 ? Math.Min(1024, copy.Length) : copy.Length);
            copy[at] ^= (byte)(1 << random.Next(8));
        }

        return copy;
    }
}
