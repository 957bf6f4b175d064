using Harvester.Play.Features;
using Harvester.Sessions.Files;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Text;

namespace Harvester.Play.Plans;

/// <summary>
/// Runs a plan in the game, trial by trial, from one press of a key to the next or until all are done. What is done is on the disk: the key
/// continues where the last run stopped, also after the game was closed.
/// </summary>
public sealed class PlanFeature : ILastingFeature, IDisposable
{
    private const string StoppedReason = "The plan was stopped.";
    private static readonly TimeSpan MaxWaitForDisk = TimeSpan.FromSeconds(2);
    private readonly string? _file;
    private readonly string _root;
    private readonly TrialSurroundings _world;
    private readonly PlayerMessages _messages;
    private readonly SlowResource<PlanFolder> _folder = new();
    private HeartbeatFile? _heartbeat;
    private HeartbeatFile? _lastHeartbeat;
    private Task _disk = Task.CompletedTask;
    private Trial? _trial;
    private TrialRun? _run;
    private int _frames;
    private bool _hasStarted;

    /// <summary>Creates the feature; it is off.</summary>
    /// <param name="file">The plan file; null without one.</param>
    /// <param name="root">The folder with the folders of all plans.</param>
    /// <param name="world">What the trials use.</param>
    /// <param name="messages">Reports what becomes of the trials.</param>
    public PlanFeature(string? file, string root, TrialSurroundings world, PlayerMessages messages)
    {
        _file = file;
        _root = root;
        _world = world;
        _messages = messages;
    }

    /// <inheritdoc/>
    public string Name => "The plan";

    /// <inheritdoc/>
    public bool IsOn => _folder.IsHeld;

    /// <inheritdoc/>
    public bool IsBusy => _folder.IsBusy || !_disk.IsCompleted || _lastHeartbeat is { IsBusy: true };

    /// <summary>Why no plan can run now; null if one can.</summary>
    public Func<string?> Obstacle { get; init; } = static () => null;

    /// <summary>Whether the plan begins without the key, once, as soon as the game lets the mod work.</summary>
    public bool StartsByItself { get; init; }

    /// <summary>The weather that is kept for the trial under way; null without one.</summary>
    public string? Weather => _world.Grip.Weather;

    /// <summary>A line about the trial under way; null without one.</summary>
    public string? Line =>
        _run is { } run && _folder.Opened is { } folder
            ? FormattableString.Invariant(
                $"PLAN  {folder.Status.Last.Values.Count(result => result.IsLast)} of {folder.Trials.Count} done  "
            ) + $"{JsonName.Of(run.Phase)}  {_trial!.Id}  {PaceText.Of(_world.Harvest.RealSecondsPerGameSecond)}".TrimEnd()
            : null;

    /// <summary>Starts or continues the plan, or stops it.</summary>
    public void Toggle()
    {
        if (IsOn)
        {
            Stop();
            _messages.Tell($"{StoppedReason} The same key continues it.");
        }
        else if (_file is not { } file)
        {
            _messages.Tell("No plan is set. Give its file under [Plan] in GtaDataHarvester.ini.");
        }
        else if (Obstacle() is { } obstacle)
        {
            _messages.Tell(obstacle);
        }
        else
        {
            _frames = 0;
            _folder.Open(() => PlanFolder.Open(file, _root));
        }
    }

    /// <inheritdoc/>
    public void Tick()
    {
        if (StartsByItself && !_hasStarted)
        {
            _hasStarted = true;
            if (!IsOn)
            {
                Toggle();
            }
        }

        if (_folder.TakeFailure() is { } failure)
        {
            _messages.Tell($"The plan cannot run: {failure.Message}");
        }

        if (!IsOn)
        {
            _world.Grip.GiveAllBack();
        }

        // The last heartbeat of the run before must not overwrite one of this run.
        if (_folder.Opened is not { } folder || !_disk.IsCompleted || _lastHeartbeat is { IsBusy: true })
        {
            return;
        }

        if (_disk.IsFaulted)
        {
            string reason = _disk.Exception!.InnerException!.Message;
            _disk = Task.CompletedTask;
            StopForDisk(reason);
            return;
        }

        if (_heartbeat is null)
        {
            if (ProblemOf(folder) is { } problem)
            {
                Stop();
                _messages.Tell($"The plan cannot run: {problem}");
                return;
            }

            _heartbeat = new HeartbeatFile(folder.Folder, folder.Plan.Name, Shard.Whole);
            _messages.Tell(PlanDuration.Of(folder, _world.Harvest.RealSecondsPerGameSecond));
            if (folder.Ended is { } ended)
            {
                TellFailure(ended);
            }
        }

        if (_run is { } run)
        {
            Continue(folder, run);
        }
        else if (_trial is { } trial)
        {
            _run = new TrialRun(_world, folder.Plan, trial, folder.FolderOf(trial), folder.RigOf(trial), folder.ScenarioOf(trial));
        }
        else if (folder.Next is { } next)
        {
            _trial = next;
            _disk = Task.Run(() => folder.Begin(next));
        }
        else
        {
            Complete(folder);
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        End(HeartbeatState.Failed);
        _world.Grip.GiveAllBack();
    }

    /// <summary>Stops, and waits for the disk, or for as long as a script may take to end.</summary>
    public void Finish()
    {
        try
        {
            Stop();
        }
        finally
        {
            _world.Car.Remove();
        }

        _disk.ContinueWith(static _ => { }, TaskScheduler.Default).Wait(MaxWaitForDisk);
        _folder.Wait(MaxWaitForDisk);
        _lastHeartbeat?.Wait();
    }

    /// <summary>Stops and waits as <see cref="Finish"/> does.</summary>
    public void Dispose() => Finish();

    private void Continue(PlanFolder folder, TrialRun run)
    {
        try
        {
            run.Tick();
        }
#pragma warning disable CA1031 // A night's work does not end because one trial meets what the game refuses.
        catch (Exception exception) when (exception is not ThreadAbortException)
#pragma warning restore CA1031
        {
            _messages.Log(exception.ToString());
            run.Stop(exception.Message);
        }

        bool isDriving = run.Phase == TrialPhase.Driving;
        _heartbeat!.Beat(
            isDriving ? HeartbeatState.Running : HeartbeatState.Starting,
            _trial!.Id,
            _frames + (isDriving ? _world.Harvest.Captured : 0)
        );
        if (run.Ending is { IsSpaceLow: true } fault)
        {
            StopForDisk(fault.Reason!);
        }
        else if (run.Ending is { } ending)
        {
            Note(folder, ending);
        }
    }

    /// <summary>Why the settings do not suit the plan; null if they do.</summary>
    private string? ProblemOf(PlanFolder folder) =>
        folder
            .Trials.Select(trial => GameRig.ProblemOf(TrialOptions.Of(_world.Options, folder.Plan, trial, folder.RigOf(trial))))
            .FirstOrDefault(problem => problem is not null);

    private void Note(PlanFolder folder, TrialEnding ending)
    {
        Trial trial = _trial!;
        int attempt = folder.Status.NextAttempt(trial.Id)!.Value;
        TrialResult result = ending.Reason is { } reason
            ? TrialResult.OfFailure(trial.Id, attempt, ending.Frames, reason)
            : new TrialResult(trial.Id, TrialState.Done, attempt, ending.Frames, null);
        (_run, _trial) = (null, null);
        _frames += result.State == TrialState.Done ? ending.Frames : 0;
        if (result.State == TrialState.Done)
        {
            _messages.Log($"{trial.Id}: {Counted.Of(ending.Frames, "frame")}.");
        }
        else
        {
            TellFailure(result);
        }

        _disk = Task.Run(() => folder.End(result));
    }

    private void TellFailure(TrialResult result) =>
        _messages.Tell(
            FormattableString.Invariant($"{result.Trial}, attempt {result.Attempt} of {TrialResult.MaxAttempts}: {result.Reason}")
                + (result.State == TrialState.Skipped ? " It is skipped." : " It is repeated.")
        );

    private void StopForDisk(string reason)
    {
        Stop();
        _messages.Tell($"The plan was stopped: {reason} The same key continues it.");
    }

    private void Complete(PlanFolder folder)
    {
        TrialResult[] skipped =
        [
            .. folder.Trials.Select(trial => folder.Status.Last[trial.Id]).Where(result => result.State == TrialState.Skipped),
        ];
        End(skipped.Length == 0 ? HeartbeatState.Finished : HeartbeatState.Incomplete);
        _messages.Tell(
            $"The plan {folder.Plan.Name} is over: {Counted.Of(folder.Trials.Count - skipped.Length, "trial")} done, "
                + (skipped.Length == 0 ? "none skipped, " : $"skipped: {string.Join(", ", skipped.Select(result => result.Trial))}, ")
                + $"in {folder.Folder}."
        );
        _world.Grip.GiveAllBack();
    }

    private void End(HeartbeatState state)
    {
        if (!IsOn)
        {
            return;
        }

        HeartbeatFile? heartbeat = _heartbeat;
        TrialRun? run = _run;
        (_heartbeat, _run, _trial) = (null, null, null);
        _folder.Close();
        heartbeat?.End(state, _frames);
        _lastHeartbeat = heartbeat ?? _lastHeartbeat;
        run?.Stop(StoppedReason);
    }
}
