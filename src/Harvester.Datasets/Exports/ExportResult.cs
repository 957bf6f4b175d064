namespace Harvester.Datasets.Exports;

/// <summary>What an export or a merge came to.</summary>
/// <param name="Frames">Frames that are done, those of an earlier run included.</param>
/// <param name="Objects">Objects in them; in a shard, 0: they are counted when the shards are merged.</param>
/// <param name="IsFinished">Whether the dataset is whole; a shard is not, before it is merged.</param>
public sealed record ExportResult(int Frames, int Objects, bool IsFinished);
