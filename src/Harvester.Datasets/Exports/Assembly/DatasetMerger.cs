using System.Collections.Generic;
using System.IO;
using System.Linq;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sharding;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Exports.Assembly;

/// <summary>Puts the shards of an export together: the same bytes as one run without shards gives.</summary>
public static class DatasetMerger
{
    /// <summary>Merges.</summary>
    /// <param name="shards">Folders that hold shards; several shards may share one.</param>
    /// <param name="folder">Where the dataset goes: one of the shards' folders, or a new or empty one; a merge that was stopped can be run
    /// again.</param>
    /// <param name="transfer">How files get from the shards into the dataset.</param>
    /// <exception cref="DatasetFormatException">A shard is missing, unfinished, twice there, or of another export.</exception>
    /// <exception cref="OccupiedFolderException">The folder holds something else.</exception>
    /// <exception cref="IOException">Something cannot be read or written.</exception>
    public static ExportResult Merge(IReadOnlyList<string> shards, string folder, ImageTransfer transfer)
    {
        var target = new DatasetFolder(folder);
        DatasetFolder[] sources = [.. shards.Select(shard => new DatasetFolder(shard))];
        if (target.HasLeftovers && IsMergeOf(sources, target))
        {
            target.Finish();
            return DatasetAssembly.ResultOf(target);
        }

        target.CheckUnfinished();

        string plan = sources[0].ReadPlan();
        if (sources.FirstOrDefault(source => source.ReadPlan() != plan) is { } other)
        {
            throw new DatasetFormatException($"'{other.Path}' and '{sources[0].Path}' are shards of different exports.");
        }

        IReadOnlyList<string> journals = CompleteJournals(sources);
        target.Begin(plan);
        foreach (DatasetFolder source in sources.Where(source => !IsSame(source, target)))
        {
            IEnumerable<string> files = Journal.ShardsIn(source).SelectMany(shard => Journal.Read(Journal.PathOf(source, shard)))
                .SelectMany(entry => entry.Files);
            foreach (string file in files)
            {
                target.Transfer(file, source.PathOf(file), transfer);
            }
        }

        return DatasetAssembly.Finish(target, journals);
    }

    /// <summary>
    /// Whether a finished dataset is of the plan of its shards; of one that was made in a shard's folder, that shard's plan is gone.
    /// </summary>
    private static bool IsMergeOf(IEnumerable<DatasetFolder> sources, DatasetFolder target)
    {
        string plan = DatasetAssembly.PlanOf(target);
        return sources.All(source => IsSame(source, target) || source.ReadPlan() == plan);
    }

    private static bool IsSame(DatasetFolder one, DatasetFolder other) => FullPathOf(one) == FullPathOf(other);

    private static string FullPathOf(DatasetFolder folder) => Path.TrimEndingDirectorySeparator(Path.GetFullPath(folder.Path));

    private static IReadOnlyList<string> CompleteJournals(DatasetFolder[] sources)
    {
        var found = new ShardSet<string>();
        foreach (DatasetFolder source in sources)
        {
            foreach (Shard shard in Journal.ShardsIn(source))
            {
                string path = Journal.PathOf(source, shard);
                if (!Journal.IsComplete(path))
                {
                    throw new DatasetFormatException($"Shard {shard} in '{source.Path}' is not finished. Run its export again.");
                }

                found.Add(shard, source.Path, path);
            }
        }

        return found.Complete();
    }
}
