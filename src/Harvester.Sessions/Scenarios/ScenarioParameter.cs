namespace Harvester.Sessions.Scenarios;

/// <summary>A parameter of a scenario file, whose value is drawn from a seed.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Min">Least value.</param>
/// <param name="Max">Greatest value.</param>
public sealed record ScenarioParameter(string Name, double Min, double Max)
{
    /// <summary>The values of which one is drawn; empty for any from the least to the greatest.</summary>
    public IReadOnlyList<double> Values { get; init; } = [];

    /// <summary>The value for a seed; it depends on nothing but the seed and the name.</summary>
    public double Drawn(int seed)
    {
        // FNV-1a, 32 bits, of the name, then two rounds of a 64-bit mixer (SplitMix64): neighbouring seeds give unlike numbers.
        uint hash = 2166136261;
        foreach (char c in Name)
        {
            hash = unchecked((hash ^ c) * 16777619);
        }

        ulong state = unchecked(((ulong)(uint)seed << 32) | hash);
        double fraction = Mixed(Mixed(state)) / 18446744073709551616.0;
        return Values.Count > 0 ? Values[Math.Min(Values.Count - 1, (int)(fraction * Values.Count))] : Min + (fraction * (Max - Min));
    }

    private static ulong Mixed(ulong state)
    {
        unchecked
        {
            ulong mixed = state + 0x9E3779B97F4A7C15;
            mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9;
            mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
            return mixed ^ (mixed >> 31);
        }
    }
}
