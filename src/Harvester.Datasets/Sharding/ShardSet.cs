using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Sharding;

/// <summary>Collects the shards of a job and checks that each is there exactly once.</summary>
/// <typeparam name="T">The data of a shard.</typeparam>
internal sealed class ShardSet<T>
{
    private const int MaxNamedShards = 100;

    private readonly SortedDictionary<int, T> _found = [];
    private int _count;

    /// <summary>Adds a shard.</summary>
    /// <exception cref="DatasetFormatException">The shard was already added, or belongs to a job with another number of shards.</exception>
    public void Add(Shard shard, string folder, T value)
    {
        _count = _count == 0 ? shard.Count : _count;
        if (shard.Count != _count)
        {
            throw new DatasetFormatException(
                $"'{folder}' is one of {shard.Count} shards, but others are of {_count}. Merge the shards of one run."
            );
        }

        if (!_found.TryAdd(shard.Number, value))
        {
            throw new DatasetFormatException($"Shard {shard} occurs twice, the second time in '{folder}'. Name each shard once.");
        }
    }

    /// <summary>All shards by number.</summary>
    /// <exception cref="DatasetFormatException">Some are missing.</exception>
    public IReadOnlyList<T> Complete()
    {
        int[] missing = [.. Enumerable.Range(1, _count).Where(number => !_found.ContainsKey(number)).Take(MaxNamedShards + 1)];
        return missing.Length == 0 ? [.. _found.Values] : throw new DatasetFormatException(MissingText(missing));
    }

    private static string MissingText(int[] missing) =>
        missing.Length switch
        {
            1 => FormattableString.Invariant($"Shard {missing[0]} is missing; run it, and name its folder too."),
            > MaxNamedShards => FormattableString.Invariant(
                $"Shards {string.Join(", ", missing[..^1])} and others are missing; run them, and name their folders too."
            ),
            _ => FormattableString.Invariant(
                $"Shards {string.Join(", ", missing[..^1])} and {missing[^1]} are missing; run them, and name their folders too."
            ),
        };
}
