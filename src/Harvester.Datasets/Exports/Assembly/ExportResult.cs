using System.Collections.Generic;

namespace Harvester.Datasets.Exports.Assembly;

/// <summary>What an export or a merge came to.</summary>
/// <param name="Format">The format.</param>
/// <param name="Frames">Frames that the dataset has; in a shard, those that are done, of an earlier run and left out ones included.</param>
/// <param name="IsFinished">Whether the dataset is whole; a shard is not, before it is merged.</param>
public sealed record ExportResult(DatasetFormat Format, int Frames, bool IsFinished)
{
    /// <summary>
    /// Frames of the sessions that the format has nothing to say of, as one about lanes of those without known lanes; in a shard, 0.
    /// </summary>
    public int FramesLeftOut { get; init; }

    /// <summary>Labels of the sessions' frames; in a shard, 0: they are counted when the shards are merged.</summary>
    public int Labels { get; init; }

    /// <summary>How many of them the dataset has, as far as the filters and the format let them in; in a shard, 0.</summary>
    public int Objects { get; init; }

    /// <summary>How many regions the dataset marks as not to be evaluated; in a shard, 0.</summary>
    public int Ignored { get; init; }

    /// <summary>The frames by split, in the order of the names; none in a shard.</summary>
    public IReadOnlyDictionary<string, int> FramesOfSplits { get; init; } = new Dictionary<string, int>();
}
