using System.Globalization;

namespace Harvester.Runs.Driving;

/// <summary>Seeds from a first to a last one.</summary>
public readonly record struct SeedRange(int First, int Last)
{
    private const int Most = 1000;

    /// <summary>The seeds in ascending order.</summary>
    public IEnumerable<int> All => Enumerable.Range(First, Last - First + 1);

    /// <summary>Parses 701-720 or 701..720; null for anything else.</summary>
    public static SeedRange? Parse(string text)
    {
        string[] ends = text.Split(text.Contains("..", StringComparison.Ordinal) ? ".." : "-");
        return ends.Length == 2 && Seed(ends[0]) is { } first && Seed(ends[1]) is { } last && last >= first && last - first < Most
            ? new SeedRange(first, last)
            : null;
    }

    /// <summary>The range as the command line writes it.</summary>
    public override string ToString() => FormattableString.Invariant($"{First}-{Last}");

    private static int? Seed(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int seed) ? seed : null;
}
