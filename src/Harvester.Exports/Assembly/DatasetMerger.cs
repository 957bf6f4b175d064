using Harvester.Datasets.Derivation;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sharding;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Assembly;

/// <summary>Merges the shards of an export; the result is byte-identical to that of a single run.</summary>
public static class DatasetMerger
{
    /// <summary>Merges shards.</summary>
    /// <param name="shards">Folders with shards; several shards may share a folder.</param>
    /// <param name="folder">Folder to write to: new, empty, or that of a shard; a stopped merge can be repeated.</param>
    /// <param name="options">How they are merged.</param>
    /// <exception cref="DatasetFormatException">A shard is missing, unfinished, given twice, or of another export.</exception>
    /// <exception cref="OccupiedFolderException">The folder has other files.</exception>
    /// <exception cref="IOException">A file cannot be read or written.</exception>
    public static ExportResult Merge(IReadOnlyList<string> shards, string folder, MergeOptions options)
    {
        var target = new DatasetFolder(folder, options.Sync);
        DatasetFolder[] sources = [.. shards.Select(shard => new DatasetFolder(shard))];
        if ((target.HasLeftovers || (options.Resume && target.IsFinished)) && IsMergeOf(sources, target))
        {
            if (target.HasLeftovers)
            {
                target.Finish();
            }

            return DatasetAssembly.ResultOf(target);
        }

        target.CheckUnfinished();

        string plan = sources[0].ReadPlan();
        if (sources.FirstOrDefault(source => source.ReadPlan() != plan) is { } other)
        {
            throw new DatasetFormatException($"'{other.Path}' and '{sources[0].Path}' are shards of different exports.");
        }

        IReadOnlyList<string> journals = CompleteJournals(sources);
        bool isNew = target.IsEmpty && !sources.Any(source => IsSame(source, target));
        bool isMade = !Directory.Exists(folder);
        try
        {
            target.Begin(plan);
            foreach (DatasetFolder source in sources)
            {
                Place(source, target, options);
            }

            return DatasetAssembly.Finish(target, journals);
        }
        catch (DatasetFormatException) when (isNew)
        {
            // No repetition can succeed with these shards, so that nothing is left for one.
            Discard(folder, isMade);
            throw;
        }
    }

    /// <summary>Deletes what was written to a folder that was empty.</summary>
    private static void Discard(string folder, bool isMade)
    {
        try
        {
            Directory.Delete(folder, recursive: true);
            if (!isMade)
            {
                Directory.CreateDirectory(folder);
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The message about the shards says what to do.
        }
    }

    /// <summary>Gives the target the files of a shard; those in place may have been written without waiting for the disk.</summary>
    private static void Place(DatasetFolder source, DatasetFolder target, MergeOptions options)
    {
        bool isInPlace = IsSame(source, target);
        var space = new SpaceWatch(target.Path, options.MinFreeBytes);
        IEnumerable<JournalEntry> entries = Journal.ShardsIn(source).SelectMany(shard => Journal.Read(Journal.PathOf(source, shard)));
        foreach (JournalEntry[] batch in entries.Chunk(target.Sync == SyncMode.Always ? 1 : SyncBatch.MaxFrames))
        {
            options.Cancellation.ThrowIfCancellationRequested();
            space.Check();
            foreach ((string file, FileDigest digest) in batch.SelectMany(entry => entry.Files))
            {
                if (isInPlace || (options.Resume && FinishedFrame.IsWhole(target.PathOf(file), digest)))
                {
                    target.Keep(file);
                }
                else
                {
                    target.Transfer(file, source.PathOf(file), options.Transfer);
                }
            }

            target.Flush();
        }
    }

    /// <summary>
    /// Whether a finished dataset has the plan of the shards. If it was assembled in the folder of a shard, that shard's plan is gone.
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
