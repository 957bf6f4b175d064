using Harvester.Sessions.Text;

namespace Harvester.Sessions.Files;

/// <summary>One of several runs that share a job; each frame belongs to exactly one of them.</summary>
public readonly record struct Shard
{
    /// <summary>Creates a shard of a run.</summary>
    /// <param name="number">The shard's number, from 1 to the number of shards.</param>
    /// <param name="count">The number of shards; at least 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">The number is not from 1 to the count.</exception>
    public Shard(int number, int count)
    {
        Count = OptionCheck.InRange(count, 1, int.MaxValue, nameof(count));
        Number = OptionCheck.InRange(number, 1, count, nameof(number));
    }

    /// <summary>The only shard of a run that is not divided.</summary>
    public static Shard Whole { get; } = new(1, 1);

    /// <summary>The shard's number, from 1.</summary>
    public int Number { get; }

    /// <summary>The number of shards.</summary>
    public int Count { get; }

    /// <summary>Whether a frame belongs to this shard; frames are dealt out in turn.</summary>
    /// <param name="frame">Number of the frame, from 0.</param>
    public bool Takes(int frame) => frame % Count == Number - 1;

    /// <summary>Number and count as text, such as 2/8.</summary>
    public override string ToString() => FormattableString.Invariant($"{Number}/{Count}");
}
