using Harvester.Capture.Faults;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Capture.Surveys;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenarios;
using Harvester.Sessions.Text;

namespace Harvester.Play.Features;

/// <summary>Starts, runs and ends harvests.</summary>
public sealed class Harvest : ILastingFeature, IDisposable
{
    private static readonly TimeSpan MaxWaitForDisk = TimeSpan.FromSeconds(10);
    private readonly string _folder;
    private readonly PlayerMessages _messages;
    private readonly IMount _mount;
    private readonly GamePorts _game;
    private readonly Func<SessionOrigin> _origin;
    private readonly SlowResource<SessionWriter> _writer = new();
    private HarvestOptions? _startedWith;
    private PaintTour? _tour;
    private HarvestSession? _session;
    private SessionWriter? _lastWriter;
    private SingleFrames? _singles;
    private FreezeReport? _freezing;
    private bool _isSingle;
    private int _lastCaptured;
    private string? _lastFault;
    private bool _isSpaceLow;
    private int _waitingSingles;
    private FaultCode[] _loggedWarnings = [];

    /// <summary>Creates the feature; no harvest is running.</summary>
    /// <param name="options">What to harvest and how.</param>
    /// <param name="folder">The folder of the sessions, each in a folder of its own.</param>
    /// <param name="messages">Reports how harvests ended.</param>
    /// <param name="mount">The camera of the harvest.</param>
    /// <param name="game">The game.</param>
    /// <param name="origin">Returns the origin of a session at the start of a harvest.</param>
    public Harvest(HarvestOptions options, string folder, PlayerMessages messages, IMount mount, GamePorts game, Func<SessionOrigin> origin)
    {
        Options = options;
        _folder = folder;
        _messages = messages;
        _mount = mount;
        _game = game;
        _origin = origin;
    }

    /// <inheritdoc/>
    public string Name => "The harvest";

    /// <summary>What to harvest and how, from the next harvest on.</summary>
    public HarvestOptions Options { get; set; }

    /// <summary>The faces of signs and heads of lights in use now.</summary>
    public Func<FaceTable> FacesInUse { get; init; } = static () => FaceTable.Empty;

    /// <summary>The faces to label: those in use, and during a harvest those with which it began.</summary>
    public FaceTable Faces => IsOn ? _startedWith!.Faces! : FacesInUse();

    /// <summary>Why this game cannot be harvested; null if it can.</summary>
    public Func<string?> Problem { get; init; } = static () => null;

    /// <inheritdoc/>
    public bool IsOn => _writer.IsHeld;

    /// <summary>The status of the running harvest; null if there is none, or its folder is not open yet.</summary>
    public HarvestStatus? Status => _session?.Status;

    /// <summary>What could not be checked or done as asked in the running harvest, and its remedy; null without a warning.</summary>
    public string? Warning =>
        _session?.Warnings is { Count: > 0 } warnings ? string.Join("  ", warnings.Select(HarvestAdvice.TextOf)) : null;

    /// <summary>Whether the running harvest was to photograph its masks and makes them from rays instead.</summary>
    public bool AreMasksReplaced => _session?.Warnings.Any(warning => warning.Code == FaultCode.NothingHidden) ?? false;

    /// <summary>
    /// Real time that the game takes for a second of its own time while frames are harvested, in the running harvest or in the last one
    /// that measured it; null before.
    /// </summary>
    public double? RealSecondsPerGameSecond { get; private set; }

    /// <summary>Whether the running harvest has a rig, whose cameras look in several directions.</summary>
    public bool HasRig => IsOn && _startedWith?.Rig is not null;

    /// <summary>Number of frames waiting to be written.</summary>
    public int Queued => _writer.Opened?.Queued ?? 0;

    /// <summary>Whether an image may be grabbed now or so soon that nothing may be drawn over it.</summary>
    public bool IsPictureNear => IsOn && (Status is not { } status || !_startedWith!.Freeze || !IsUndisturbed(status.Phase));

    /// <inheritdoc/>
    public bool IsBusy => _writer.IsBusy;

    /// <summary>Number of frames of the running harvest, or of the last one.</summary>
    public int Captured =>
        _session is { } session ? session.Status.Captured
        : IsOn ? 0
        : _lastCaptured;

    /// <summary>Why the last harvest ended early; null if it ended normally, or none has ended.</summary>
    public string? LastFault => _lastFault ?? (IsBusy ? null : _lastWriter?.Fault);

    /// <summary>Whether the last harvest ended because the disk has too little space.</summary>
    public bool IsSpaceLow => _isSpaceLow || (!IsBusy && _lastWriter is { IsSpaceLow: true });

    /// <summary>Starts a harvest in a given folder, unless one is running.</summary>
    /// <param name="folder">The folder, which must not exist.</param>
    /// <param name="options">What to harvest and how; the faces in use are added.</param>
    /// <param name="tour">The tour on which the frames are taken; null to take them while someone drives.</param>
    /// <param name="scenario">What the session keeps of a scenario; null without one.</param>
    public void StartIn(string folder, HarvestOptions options, PaintTour? tour = null, KeptScenario? scenario = null)
    {
        if (!IsOn)
        {
            SessionOrigin origin = _origin();
            origin = scenario is null ? origin : origin with { Settings = [.. origin.Settings, .. scenario.Settings] };
            (_isSingle, _lastCaptured, _lastFault, _isSpaceLow, _tour) = (false, 0, null, false, tour);
            Start(options with { Faces = FacesInUse() }, () => Kept(SessionPlace.Locked(folder, origin, options.ViewsPerMoment), scenario));
        }
    }

    /// <summary>Starts a harvest in a folder of its own, or ends the one that is running.</summary>
    public void Toggle()
    {
        if (!IsOn)
        {
            SessionOrigin origin = _origin();
            (_isSingle, _tour) = (false, null);
            Start(
                Options with
                {
                    Faces = FacesInUse(),
                },
                () => SessionPlace.Locked(SessionPlace.NewIn(_folder, "session"), origin, Options.ViewsPerMoment)
            );
        }
        else
        {
            Stop();
        }
    }

    /// <summary>
    /// Harvests one frame, after those that were asked for before and are not yet taken or written. The single frames of one run of the
    /// game form a session, as long as lens and faces do not change.
    /// </summary>
    public void TakeOne()
    {
        if (IsOn && !_isSingle)
        {
            _messages.Tell("A harvest is running already.");
            return;
        }

        if (IsOn || IsBusy)
        {
            _waitingSingles++;
            _messages.Log(FormattableString.Invariant($"Single frames waiting: {_waitingSingles}."));
            return;
        }

        HarvestOptions options = Options with
        {
            MaxFrames = Options.ViewsPerMoment,
            ProbeLag = false,
            ChecksDisplay = false,
            Faces = FacesInUse(),
            KnownFreezing = _freezing is { IsConclusive: true } ? _freezing : null,
        };
        SessionOrigin origin = _origin();
        (_isSingle, _tour) = (true, null);
        if (_singles is { } singles && singles.Lens == options.Lens && singles.Faces == options.Faces)
        {
            Start(
                singles.CalibrationErrorPixels is { } known
                    ? options with
                    {
                        MaxCalibrationErrorPixels = null,
                        KnownCalibrationErrorPixels = known,
                    }
                    : options,
                () => SessionPlace.Locked(singles.Folder, origin, Options.ViewsPerMoment, resume: true)
            );
        }
        else
        {
            Start(options, () => SessionPlace.Locked(SessionPlace.NewIn(_folder, "singles"), origin, Options.ViewsPerMoment));
        }
    }

    /// <inheritdoc/>
    public void Tick()
    {
        TellLateFault();
        if (!IsOn)
        {
            TakeWaiting();
            return;
        }

        if (!_mount.IsMounted)
        {
            Stop();
        }
        else if ((_session ??= Begin()) is { } session)
        {
            HarvestStatus status = session.Step();
            KeepFreezing(session);
            RealSecondsPerGameSecond = session.RealSecondsPerGameSecond ?? RealSecondsPerGameSecond;
            LogWarnings(session);
            if (status.IsOver)
            {
                Close(session);
            }
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        _waitingSingles = 0;
        if (_session is { } session)
        {
            session.Stop();
            Close(session);
        }
        else if (IsOn)
        {
            _writer.Close();
            _messages.Tell("The harvest was stopped before its first frame.");
        }
    }

    /// <summary>Stops, and waits until everything accepted is on disk, or for as long as a script may take to end.</summary>
    public void Finish()
    {
        Stop();
        _writer.Wait(MaxWaitForDisk);
        TellLateFault();
    }

    /// <inheritdoc cref="Finish"/>
    public void Dispose() => Finish();

    /// <summary>Whether in a phase no picture is grabbed, nor soon.</summary>
    private static bool IsUndisturbed(HarvestPhase phase) =>
        phase is HarvestPhase.Waiting or HarvestPhase.Travelling or HarvestPhase.WaitingForSink;

    private void Start(HarvestOptions options, Func<SessionWriter> open)
    {
        if (IsBusy)
        {
            _messages.Tell("The last harvest is still being written. Try again in a moment.");
            return;
        }

        if ((Problem() ?? GameRig.ProblemOf(options)) is { } problem)
        {
            _messages.Tell(problem);
            return;
        }

        if (!_mount.IsMounted)
        {
            _mount.Mount();
        }

        if (_mount.IsMounted && options.Rig is { } rig && GameRig.BodyProblem(rig, _game.World.ReadEgo(), _game.Rays) is { } inside)
        {
            _messages.Tell(inside);
            return;
        }

        if (_mount.IsMounted)
        {
            // Resuming reads the session, and a disk may have to spin up.
            _loggedWarnings = [];
            _startedWith = options;
            _writer.Open(open);
        }
    }

    private static SessionWriter Kept(SessionWriter writer, KeptScenario? scenario)
    {
        if (scenario is not null)
        {
            writer.KeepAtEnd(ScenarioRecord.FileName, scenario.Text);
        }

        return writer;
    }

    /// <summary>Takes the next single frame once the one before is written; unmounting the camera cancels those that wait.</summary>
    private void TakeWaiting()
    {
        if (_waitingSingles == 0 || IsBusy)
        {
            return;
        }

        int others = _mount.IsMounted ? _waitingSingles - 1 : 0;
        bool isNext = _mount.IsMounted;
        _waitingSingles = 0;
        if (isNext)
        {
            TakeOne();
            _waitingSingles = IsOn ? others : 0;
        }
    }

    private HarvestSession? Begin()
    {
        if (_writer.TakeFailure() is { } failure)
        {
            throw failure;
        }

        if (_writer.Opened is not { } writer)
        {
            return null;
        }

        if (_startedWith!.Rig is { } rig)
        {
            _messages.Log(
                FormattableString.Invariant(
                    $"The rig '{rig.Name}' takes about {GameRig.SecondsPerMoment(_startedWith):0.0} s per moment at 60 ticks a second."
                )
            );
            if (GameRig.AspectWarning(rig, _game.World.ReadCamera().WindowAspect) is { } warning)
            {
                _messages.Tell(warning);
            }

            _game.RigCamera!.Show(rig.Cameras[0], rig.OnVehicle(rig.Cameras[0].Mount));
        }

        return new HarvestSession(_startedWith, _tour?.Ports ?? _game, writer) { Tour = _tour };
    }

    /// <summary>Keeps the findings about freeze methods for the following single frames.</summary>
    private void KeepFreezing(HarvestSession session)
    {
        if (session.Freezing is { } found && found != _freezing)
        {
            _freezing = found;
            _messages.Log($"Freeze = Auto: {found}");
        }
    }

    /// <summary>Logs each warning once, when it is known; the player sees it in the lines at the top and as a message at the end.</summary>
    private void LogWarnings(HarvestSession session)
    {
        foreach (CaptureFault warning in session.Warnings.Where(warning => !_loggedWarnings.Contains(warning.Code)))
        {
            _messages.Log(HarvestAdvice.TextOf(warning));
            _loggedWarnings = [.. _loggedWarnings, warning.Code];
        }
    }

    private void Close(HarvestSession session)
    {
        if (session.Failure is not null)
        {
            _waitingSingles = 0;
        }

        SessionWriter writer = _writer.Opened!;
        HarvestStatus status = session.Status;
        (_lastCaptured, _lastFault) = (status.Captured, session.Failure is { } failure ? failure.Message : null);
        _isSpaceLow = writer.IsSpaceLow;
        _session = null;
        _writer.Close();
        if (_startedWith!.Rig is not null || _tour is not null)
        {
            _mount.MoveBack();
        }

        _lastWriter = status.Fault is null ? writer : null;
        if (_isSingle && status.Captured > 0)
        {
            _singles = new SingleFrames(writer.Folder, _startedWith!.Lens, _startedWith.Faces!, session.CalibrationErrorPixels);
        }

        Tell(session, writer.FramesWritten == 0 && writer.RemovesFailedStart);
    }

    private void Tell(HarvestSession session, bool isNew)
    {
        HarvestStatus status = session.Status;
        string discards = string.Join(
            ", ",
            session.Counters.Discards.Select(discard => FormattableString.Invariant($"{discard.Value} {discard.Key}"))
        );
        string counts = Counted.Of(status.Captured, "frame") + (discards.Length > 0 ? $", discarded: {discards}" : string.Empty);
        if (session.Calls.Phases.Count > 0)
        {
            _messages.Log($"The harvest asked of the game: {session.Calls}");
        }

        foreach (CaptureFault warning in session.Warnings)
        {
            _messages.Tell(HarvestAdvice.TextOf(warning));
        }

        string kept = status is { Captured: 0, Discarded: 0 } && isNew ? $"{counts}; its empty folder is removed" : counts;
        _messages.Tell(
            session.Failure is { } fault ? $"{HarvestAdvice.TextOf(fault)} ({kept})" : $"The harvest ended: {counts}, in {_folder}."
        );
    }

    /// <summary>The last frames are written when the harvest is over: their write errors are reported once they are known.</summary>
    private void TellLateFault()
    {
        if (_lastWriter is not { } writer || IsBusy)
        {
            return;
        }

        _lastWriter = null;
        if (writer.Fault is { } fault)
        {
            _isSpaceLow |= writer.IsSpaceLow;
            _lastFault ??= fault;
            _messages.Tell(fault);
            _singles = null;
        }
    }

    /// <summary>The session of the single frames. Its camera model is checked until the check has succeeded once.</summary>
    private sealed record SingleFrames(string Folder, Lens Lens, FaceTable Faces, double? CalibrationErrorPixels);
}
