using System;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Files;

/// <summary>One of several runs that do a job side by side: every frame belongs to exactly one.</summary>
public readonly record struct Shard
{
    /// <summary>Creates a shard of a run.</summary>
    /// <param name="number">Its number, from 1 to the number of shards.</param>
    /// <param name="count">How many there are.</param>
    /// <exception cref="ArgumentOutOfRangeException">The number is not 1 to the count.</exception>
    public Shard(int number, int count)
    {
        Count = OptionCheck.InRange(count, 1, int.MaxValue, nameof(count));
        Number = OptionCheck.InRange(number, 1, count, nameof(number));
    }

    /// <summary>The only shard of a run that is not divided.</summary>
    public static Shard Whole { get; } = new(1, 1);

    /// <summary>Its number, from 1.</summary>
    public int Number { get; }

    /// <summary>How many there are.</summary>
    public int Count { get; }

    /// <summary>Whether a frame belongs to it: the frames go round.</summary>
    /// <param name="frame">Number of the frame, from 0.</param>
    public bool Takes(int frame) => frame % Count == Number - 1;

    /// <summary>As 2/8.</summary>
    public override string ToString() => FormattableString.Invariant($"{Number}/{Count}");
}
