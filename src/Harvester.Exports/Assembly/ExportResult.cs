namespace Harvester.Exports.Assembly;

/// <summary>The result of an export or merge.</summary>
/// <param name="Format">The format.</param>
/// <param name="Frames">Number of frames of the dataset; for a shard, of the frames done, including those of earlier runs and those left
/// out.</param>
/// <param name="IsFinished">Whether the dataset is finished; false for a shard.</param>
public sealed record ExportResult(DatasetFormat Format, int Frames, bool IsFinished)
{
    /// <summary>Number of frames that the format leaves out, such as frames without known lanes in a lane format; 0 for a shard.</summary>
    public int FramesLeftOut { get; init; }

    /// <summary>Number of labels in the sessions; 0 for a shard, because they are counted in the merge.</summary>
    public int Labels { get; init; }

    /// <summary>
    /// Number of labels of posts whose faces or heads are exported instead; 0 for a shard, and in formats without such parts.
    /// </summary>
    public int Posts { get; init; }

    /// <summary>Number of labels written, after filters; 0 for a shard.</summary>
    public int Objects { get; init; }

    /// <summary>Number of ignore regions written; 0 for a shard.</summary>
    public int Ignored { get; init; }

    /// <summary>Number of frames by split, sorted by name; empty for a shard.</summary>
    public IReadOnlyDictionary<string, int> FramesOfSplits { get; init; } = new Dictionary<string, int>();
}
