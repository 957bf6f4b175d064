using Harvester.Datasets.Outputs;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;
using Harvester.Runs.Ports;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Text;

namespace Harvester.Runs.Plans;

/// <summary>Harvests the trials of a plan one after another from the simulated game.</summary>
/// <param name="log">Receives a line for each trial, and warnings.</param>
/// <param name="file">The plan.</param>
/// <param name="world">The simulated world.</param>
/// <param name="output">Where to write to.</param>
/// <param name="heartbeat">Receives signs of life.</param>
/// <param name="command">The command, as the marks of unfinished sessions have it.</param>
public sealed class PlanRun(IRunLog log, PlanFile file, PlanWorld world, PlanOutput output, HeartbeatFile heartbeat, string command)
{
    private int _frames;

    /// <summary>Number of images so far.</summary>
    public int Frames => _frames;

    /// <summary>How the disk is used.</summary>
    public PlanDisk Disk { get; init; } = new();

    /// <summary>Whether each trial that is done is noted in the log.</summary>
    public bool NotesTrials { get; init; } = true;

    /// <summary>Number of images of a trial, if its drive is not over earlier.</summary>
    public static int ImagesOf(PlanFile file, Trial trial) =>
        file.Plan.FramesAt(trial.Place) * (file.Rigs.TryGetValue(trial.Camera.Name, out Rig? rig) ? rig.Cameras.Count : 1);

    /// <summary>Runs the trials that are not done.</summary>
    /// <param name="trials">All trials of this run.</param>
    /// <param name="report">Receives the number of images so far.</param>
    /// <param name="cancellation">Stops between two ticks.</param>
    /// <returns>Whether all trials were run; false if the disk failed, which the log names.</returns>
    /// <exception cref="IOException">A file cannot be written.</exception>
    public bool Run(IReadOnlyList<Trial> trials, Action<int> report, CancellationToken cancellation)
    {
        output.DeleteLeftLocks(trials);
        foreach (Trial trial in output.Left(trials))
        {
            int before = _frames;
            while (output.Status.NextAttempt(trial.Id) is { } attempt)
            {
                _frames = before;
                cancellation.ThrowIfCancellationRequested();
                heartbeat.Beat(HeartbeatState.Starting, trial.Id, _frames);
                if (Attempt(trial, attempt, report, cancellation) is not { } result)
                {
                    return false;
                }

                output.Status.Add(result);
                Tell(result);
            }

            _frames = before + ImagesOf(file, trial);
            report(_frames);
        }

        return true;
    }

    /// <summary>One attempt; null if the disk failed, which is no fault of the trial.</summary>
    private TrialResult? Attempt(Trial trial, int attempt, Action<int> report, CancellationToken cancellation)
    {
        string folder = output.FolderOf(trial);
        if (output.IsComplete(trial))
        {
            return new TrialResult(trial.Id, TrialState.Done, attempt, new SessionReader(folder).ReadLabels().Count(), null);
        }

        HarvestPlan plan = TrialPlan.Of(file, world, trial, attempt, folder, Disk);
        int before = _frames;
        int captured = 0;
        HarvestOutcome outcome;
        try
        {
            using var session = new SessionOutput(
                log.Warn,
                folder,
                FormattableString.Invariant($"{command} (trial {trial.Id}, attempt {attempt})"),
                overwrite: null,
                keepsFrames: true,
                resumes: true
            );
            SimulatedHarvest harvest = SimulatedHarvest.Build(plan, log.Warn);
            outcome = harvest.Run(session.Begin(), Report, cancellation);
            if (outcome is { Fault: null, IsCancelled: false, Frames: > 0 })
            {
                session.Complete();
            }
        }
        catch (UsageException e)
        {
            output.Discard(trial);
            return TrialResult.OfFailure(trial.Id, attempt, captured, MessageLine.Of(e.Message));
        }

        if (outcome.IsDiskFault)
        {
            log.Warn($"{trial.Id}: {outcome.Fault} Run the command again with --resume.");
            return null;
        }

        if (outcome.Fault is null && outcome.IsCancelled)
        {
            throw new OperationCanceledException(cancellation);
        }

        string? reason = outcome.Fault ?? (outcome.Frames == 0 ? "The drive was over before the first frame." : null);
        if (reason is null)
        {
            return new TrialResult(trial.Id, TrialState.Done, attempt, outcome.Frames, null);
        }

        output.Discard(trial);
        return TrialResult.OfFailure(trial.Id, attempt, outcome.Frames, MessageLine.Of(reason));

        void Report(int frames)
        {
            captured = frames;
            _frames = before + frames;
            heartbeat.Beat(HeartbeatState.Running, trial.Id, _frames);
            report(_frames);
        }
    }

    private void Tell(TrialResult result)
    {
        if (result.State != TrialState.Done)
        {
            log.Warn(
                FormattableString.Invariant($"{result.Trial}, attempt {result.Attempt} of {TrialResult.MaxAttempts}: {result.Reason}")
            );
        }
        else if (NotesTrials)
        {
            log.Note($"{result.Trial}: {Counted.Of(result.Frames, "frame")}");
        }
    }
}
