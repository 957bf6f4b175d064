namespace Harvester.Exports;

/// <summary>
/// Assigns frames to splits. A hash of seed, session and place selects the split of all frames of a place, so the split of a frame does
/// not depend on other frames, shards or filters. On request, blocks of consecutive frames take the part of places. The fractions hold on
/// average, not exactly.
/// </summary>
public sealed class SplitPlan
{
    /// <summary>Tolerance of the sum of fractions: users write 0.333 for a third.</summary>
    private const double ShareTolerance = 0.01;

    /// <summary>With each seed, a split of a thousandth of the frames or more is empty for few sets of places.</summary>
    private const int MaxSeedTried = 1000;

    private readonly int _seed;

    /// <summary>Creates a plan.</summary>
    /// <param name="splits">The splits; their names differ, also without regard to case as on Windows, and their fractions add up
    /// to 1.</param>
    /// <param name="seed">Random seed.</param>
    /// <param name="blockFrames">Number of consecutive frames that stay together, at least 1; null for all frames of a place.</param>
    /// <exception cref="ArgumentException">The splits do not meet these conditions.</exception>
    public SplitPlan(IReadOnlyList<DatasetSplit> splits, int seed, int? blockFrames = null)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(blockFrames ?? 1, 1, nameof(blockFrames));
        if (
            splits.Count == 0
            || splits.Select(split => split.Name).Distinct(StringComparer.OrdinalIgnoreCase).Count() != splits.Count
            || splits.Any(split => !IsName(split.Name) || !(split.ShareFraction > 0))
        )
        {
            throw new ArgumentException(
                "Splits need names of letters, digits, - and _ that differ in more than upper and lower case, "
                    + "and fractions greater than 0."
            );
        }

        if (Math.Abs(splits.Sum(split => split.ShareFraction) - 1) > ShareTolerance)
        {
            throw new ArgumentException("The fractions must add up to 1.");
        }

        Splits = splits;
        _seed = seed;
        BlockFrames = blockFrames;
    }

    /// <summary>All frames in one split named train.</summary>
    public static SplitPlan Everything { get; } = new([new DatasetSplit("train", 1)], 0);

    /// <summary>The splits.</summary>
    public IReadOnlyList<DatasetSplit> Splits { get; }

    /// <summary>Number of consecutive frames that stay together; null for all frames of a place.</summary>
    public int? BlockFrames { get; }

    /// <summary>Random seed.</summary>
    public int Seed => _seed;

    /// <summary>The split of a frame.</summary>
    /// <param name="frame">The frame.</param>
    public string Of(FramePlace frame)
    {
        double drawn = Draw(frame.Session, BlockFrames is { } block ? frame.Frame / block : frame.Place);
        double reached = 0;
        foreach (DatasetSplit split in Splits)
        {
            reached += split.ShareFraction;
            if (drawn < reached)
            {
                return split.Name;
            }
        }

        return Splits[^1].Name;
    }

    /// <summary>The first split that gets none of some frames; null if each gets one.</summary>
    /// <param name="frames">The frames.</param>
    internal string? FirstEmpty(IEnumerable<FramePlace> frames)
    {
        HashSet<string> empty = [.. Splits.Select(split => split.Name)];
        foreach (FramePlace frame in frames)
        {
            empty.Remove(Of(frame));
            if (empty.Count == 0)
            {
                return null;
            }
        }

        return Splits.First(split => empty.Contains(split.Name)).Name;
    }

    /// <summary>The smallest seed, up to 1,000, that gives every split some of the frames; null if there is none.</summary>
    /// <param name="frames">The frames.</param>
    internal int? FirstFullSeed(IReadOnlyCollection<FramePlace> frames)
    {
        FramePlace[] kinds = [.. BlockFrames is null ? frames.DistinctBy(frame => (frame.Session, frame.Place)) : frames];
        return Enumerable
            .Range(0, MaxSeedTried + 1)
            .Where(seed => new SplitPlan(Splits, seed, BlockFrames).FirstEmpty(kinds) is null)
            .Select(seed => (int?)seed)
            .FirstOrDefault();
    }

    /// <summary>The largest block size, below this plan's if it has one, that gives every split some of the frames; null if there is none.
    /// </summary>
    /// <param name="frames">The frames.</param>
    internal int? LargestFullBlock(IReadOnlyCollection<FramePlace> frames)
    {
        int largest = Math.Min((BlockFrames ?? int.MaxValue) - 1, frames.Max(frame => frame.Frame) + 1);
        for (int block = largest; block >= 1; block--)
        {
            if (new SplitPlan(Splits, Seed, block).FirstEmpty(frames) is null)
            {
                return block;
            }
        }

        return null;
    }

    private static bool IsName(string name) => name.Length > 0 && name.All(c => char.IsAsciiLetterOrDigit(c) || c is '-' or '_');

    private double Draw(int session, int block)
    {
        ulong hash = Mix(Mix(Mix((uint)_seed) ^ (uint)session) ^ (uint)block);
        const double steps = 1UL << 53;
        return (hash >> 11) / steps;
    }

    /// <summary>The finaliser of SplitMix64 (Steele, Lea, Flood 2014).</summary>
    private static ulong Mix(ulong value)
    {
        unchecked
        {
            ulong z = value + 0x9E3779B97F4A7C15;
            z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
            z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
            return z ^ (z >> 31);
        }
    }
}
