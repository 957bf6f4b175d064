using Harvester.Datasets.Derivation;
using Harvester.Datasets.Files;
using Harvester.Datasets.Outputs;
using Harvester.Sessions.Files;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Runs.Plans;

/// <summary>The folder of a plan's output: a copy of the plan, the status of its trials, and a session for each trial.</summary>
public sealed class PlanOutput : IDisposable
{
    private const string World = "world.json";
    private readonly PlanResults _results;

    private PlanOutput(PlanResults results) => _results = results;

    /// <summary>The folder.</summary>
    public string Folder => _results.Folder;

    /// <summary>The status of the trials.</summary>
    public PlanStatus Status => _results.Status;

    /// <summary>The folder with the sessions.</summary>
    public string Trials => _results.Trials;

    /// <summary>Locks and checks the folder, and makes it if it is missing.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="plan">The text of the plan.</param>
    /// <param name="world">What tells the plan's world from others.</param>
    /// <param name="shard">The part of the plan to run.</param>
    /// <param name="resumes">Whether to continue an earlier run.</param>
    /// <param name="minFreeBytes">Space that is to stay free on the disk, bytes; 0 watches nothing.</param>
    /// <exception cref="OccupiedFolderException">The folder is in use, or has other files than results of the plan.</exception>
    /// <exception cref="DatasetFormatException">The status file is damaged.</exception>
    /// <exception cref="IOException">The folder cannot be made or read.</exception>
    public static PlanOutput Open(string folder, string plan, string world, Shard shard, bool resumes, long minFreeBytes)
    {
        string part = shard.Count == 1 ? "" : FormattableString.Invariant($".{shard.Number}-of-{shard.Count}");
        var results = new PlanResults(folder, FolderLock.Take(folder, part));
        try
        {
            OutputDisk.Check(folder, "--out", minFreeBytes);
            string copy = Path.Combine(folder, PlanResults.PlanCopy);
            if (
                !File.Exists(copy)
                && Directory.Exists(folder)
                && Directory.EnumerateFileSystemEntries(folder).Any(path => AtomicFile.TargetOf(Path.GetFileName(path)) is null)
            )
            {
                throw new OccupiedFolderException($"'{folder}' is not empty and has no plan. Name another folder with --out.");
            }

            Directory.CreateDirectory(folder);
            if (shard.Count == 1)
            {
                AtomicFile.DeleteLeftovers(folder, static name => name is PlanResults.PlanCopy or World);
            }

            if (!results.Keep(PlanResults.PlanCopy, plan))
            {
                throw new OccupiedFolderException($"{results.OfAnotherPlan} Name another folder with --out.");
            }

            if (results.HasResults(shard) && !resumes)
            {
                throw new OccupiedFolderException(
                    $"'{folder}' has results of this plan. Continue with --resume, or name another folder with --out."
                );
            }

            if (!results.Keep(World, world))
            {
                throw new OccupiedFolderException(
                    $"'{folder}' has results of other roads, other paint or another detail. Give --roads, --paint and --detail as then, or "
                        + "name another folder with --out."
                );
            }

            results.ReadStatus(shard);
            return new PlanOutput(results);
        }
        catch (FormatException e)
        {
            results.Dispose();
            throw new DatasetFormatException($"'{folder}': {e.Message}", e);
        }
        catch
        {
            results.Dispose();
            throw;
        }
    }

    /// <summary>The trials that need an attempt, in their order.</summary>
    public IEnumerable<Trial> Left(IEnumerable<Trial> trials) => _results.Left(trials);

    /// <summary>The folder of a trial's session.</summary>
    /// <exception cref="IOException">It or the folder of all trials is a link.</exception>
    public string FolderOf(Trial trial)
    {
        string folder = _results.FolderOf(trial);
        foreach (string path in new[] { _results.Trials, folder }.Where(Directory.Exists))
        {
            AppendedFile.RefuseLink(path);
        }

        return folder;
    }

    /// <summary>Whether a trial has a complete session, which a command that was stopped then may not have noted.</summary>
    public bool IsComplete(Trial trial) =>
        File.Exists(Path.Combine(FolderOf(trial), SessionInfo.FileName)) && UnfinishedMark.CommandIn(FolderOf(trial)) is null;

    /// <summary>Deletes the locks of trials' sessions that a run which was stopped has left.</summary>
    /// <param name="trials">Trials that only this run writes.</param>
    public void DeleteLeftLocks(IEnumerable<Trial> trials)
    {
        string folder = _results.Trials;
        string[] names = Directory.Exists(folder) ? [.. Directory.EnumerateFiles(folder).Select(file => Path.GetFileName(file))] : [];
        foreach (Trial trial in trials.Where(trial => names.Any(name => WriterLock.IsOf(name, trial.Id))))
        {
            WriterLock.Take(FolderOf(trial)).Dispose();
        }
    }

    /// <summary>Deletes what a failed attempt wrote.</summary>
    public void Discard(Trial trial)
    {
        string folder = FolderOf(trial);
        if (Directory.Exists(folder))
        {
            SessionFolder.Clear(folder);
            UnfinishedMark.Delete(folder);
            Directory.Delete(folder);
        }
    }

    /// <summary>Releases the folder.</summary>
    public void Dispose() => _results.Dispose();
}
