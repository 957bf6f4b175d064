using Harvester.Datasets.Files;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Sharding;

/// <summary>How shards are merged. None of it changes the result.</summary>
/// <param name="Transfer">Whether files are linked or copied.</param>
/// <param name="Sync">When to wait for the disk.</param>
/// <param name="Resume">Whether to keep what a stopped merge of the same shards finished in the folder, as far as it is whole.</param>
/// <param name="MinFreeBytes">Space that stays free on the disk, bytes; 0 watches nothing.</param>
/// <param name="Cancellation">Stops the merge between two frames.</param>
public readonly record struct MergeOptions(
    ImageTransfer Transfer,
    SyncMode Sync = SyncMode.Batch,
    bool Resume = false,
    long MinFreeBytes = 0,
    CancellationToken Cancellation = default
);
