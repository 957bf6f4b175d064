namespace Harvester.Capture.Labelling;

/// <summary>Random numbers for the errors of sensors, the same on every platform.</summary>
/// <param name="seed">The seed.</param>
internal sealed class NoiseSource(ulong seed)
{
    private ulong _state = Mixed(seed);

    /// <summary>The next number of SplitMix64 (Steele, Lea and Flood 2014), from 0 to below 1.</summary>
    public double Next()
    {
        _state = unchecked(_state + 0x9E3779B97F4A7C15);

        // 53 bits, the precision of a double, times 2^-53.
        return (Mixed(_state) >> 11) * (1.0 / (1UL << 53));
    }

    /// <summary>A normal number of mean 0 and variance 1: Box and Muller's transform of two uniform numbers.</summary>
    public double NextNormal()
    {
        double radius = Math.Sqrt(-2 * Math.Log(1 - Next()));
        return radius * Math.Cos(2 * Math.PI * Next());
    }

    /// <summary>The FNV-1a hash of a name.</summary>
    public static ulong HashOf(string name) =>
        name.Aggregate(0xCBF29CE484222325, static (hash, letter) => unchecked((hash ^ letter) * 0x100000001B3));

    private static ulong Mixed(ulong state)
    {
        unchecked
        {
            ulong mixed = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9;
            mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
            return mixed ^ (mixed >> 31);
        }
    }
}
