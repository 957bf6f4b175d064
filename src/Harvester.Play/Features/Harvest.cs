using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Harvester.Capture.Faults;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Faces;

namespace Harvester.Play.Features;

/// <summary>Starts, drives and ends harvests by the keys.</summary>
public sealed class Harvest : ILastingFeature, IDisposable
{
    private static readonly TimeSpan MaxWaitForDisk = TimeSpan.FromSeconds(10);
    private readonly string _folder;
    private readonly PlayerMessages _messages;
    private readonly IMount _mount;
    private readonly GamePorts _game;
    private readonly IDisplay _display;
    private readonly Func<SessionOrigin> _origin;
    private readonly SlowResource<SessionWriter> _writer = new();
    private HarvestOptions? _startedWith;
    private HarvestSession? _session;
    private SessionWriter? _lastWriter;
    private SingleFrames? _singles;
    private FreezeReport? _freezing;
    private bool _isSingle;

    /// <summary>Makes ready for harvests of a game.</summary>
    /// <param name="options">What to harvest and how.</param>
    /// <param name="folder">Where sessions go, each into a folder of its own.</param>
    /// <param name="messages">Tells how harvests ended.</param>
    /// <param name="mount">The camera that harvests.</param>
    /// <param name="game">The game.</param>
    /// <param name="display">The game's own display is hidden while a harvest runs.</param>
    /// <param name="origin">Tells at the start of a harvest where its session comes from.</param>
    public Harvest(
        HarvestOptions options, string folder, PlayerMessages messages, IMount mount, GamePorts game, IDisplay display,
            Func<SessionOrigin> origin)
    {
        Options = options;
        _folder = folder;
        _messages = messages;
        _mount = mount;
        _game = game;
        _display = display;
        _origin = origin;
    }

    /// <inheritdoc/>
    public string Name => "The harvest";

    /// <summary>What to harvest and how, from the next harvest on.</summary>
    public HarvestOptions Options { get; set; }

    /// <summary>The faces of signs and heads of lights that are in use now.</summary>
    public Func<FaceTable> FacesInUse { get; init; } = static () => FaceTable.Empty;

    /// <summary>The faces to label: those in use, and while a harvest is on those that were when it began.</summary>
    public FaceTable Faces => IsOn ? _startedWith!.Faces! : FacesInUse();

    /// <summary>Why this game cannot be harvested; null when it can.</summary>
    public Func<string?> Problem { get; init; } = static () => null;

    /// <inheritdoc/>
    public bool IsOn => _writer.IsHeld;

    /// <summary>How the harvest that runs stands; null when none does, or when its folder is not open yet.</summary>
    public HarvestStatus? Status => _session?.Status;

    /// <summary>Frames that wait to be written.</summary>
    public int Queued => _writer.Opened?.Queued ?? 0;

    /// <summary>Whether a picture may be grabbed now or so soon that nothing of ours may be drawn.</summary>
    public bool IsPictureNear =>
        IsOn && (Status is not { } status || !_startedWith!.Freeze
            || status.Phase is not (HarvestPhase.Waiting or HarvestPhase.WaitingForSink));

    /// <inheritdoc/>
    public bool IsBusy => _writer.IsBusy;

    /// <summary>Starts a harvest in a folder of its own, or ends the one that runs.</summary>
    public void Toggle()
    {
        if (!IsOn)
        {
            SessionOrigin origin = _origin();
            _isSingle = false;
            Start(Options with { Faces = FacesInUse() }, () => new SessionWriter(NewFolder("session"), origin));
        }
        else
        {
            Stop();
        }
    }

    /// <summary>
    /// Harvests one frame. The single frames of one run of the game make a session together, as long as lens and faces are the same.
    /// </summary>
    public void TakeOne()
    {
        if (IsOn)
        {
            _messages.Tell("A harvest is running already.");
            return;
        }

        HarvestOptions options = Options with
        {
            MaxFrames = 1,
            ProbeLag = false,
            Faces = FacesInUse(),
            KnownFreezing = _freezing is { IsConclusive: true } ? _freezing : null
        };
        SessionOrigin origin = _origin();
        _isSingle = true;
        if (_singles is { } singles && singles.Lens == options.Lens && singles.Faces == options.Faces)
        {
            Start(
                singles.CalibrationErrorPixels is { } known
                    ? options with { MaxCalibrationErrorPixels = null, KnownCalibrationErrorPixels = known } : options,
                () => new SessionWriter(singles.Folder, origin, resume: true));
        }
        else
        {
            Start(options, () => new SessionWriter(NewFolder("singles"), origin));
        }
    }

    /// <inheritdoc/>
    public void Tick()
    {
        TellLateFault();
        if (!IsOn)
        {
            return;
        }

        _display.HideGames();
        if (!_mount.IsMounted)
        {
            Stop();
        }
        else if ((_session ??= Begin()) is { } session)
        {
            HarvestStatus status = session.Step();
            KeepFreezing(session);
            if (status.IsOver)
            {
                Close(session);
            }
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
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

    /// <summary>Stops, and waits until everything taken is on disk, or for as long as a script may take to end.</summary>
    public void Finish()
    {
        Stop();
        _writer.Wait(MaxWaitForDisk);
        TellLateFault();
    }

    /// <inheritdoc cref="Finish"/>
    public void Dispose() => Finish();

    private void Start(HarvestOptions options, Func<SessionWriter> open)
    {
        if (IsBusy)
        {
            _messages.Tell("The last harvest is still being written. Try again in a moment.");
            return;
        }

        if (Problem() is { } problem)
        {
            _messages.Tell(problem);
            return;
        }

        if (!_mount.IsMounted)
        {
            _mount.Mount();
        }

        if (_mount.IsMounted)
        {
            // A session that is gone on with is read, and a disk may sleep.
            _startedWith = options;
            _writer.Open(open);
        }
    }

    private HarvestSession? Begin()
    {
        if (_writer.TakeFailure() is { } failure)
        {
            throw failure;
        }

        return _writer.Opened is { } writer ? new HarvestSession(_startedWith!, _game, writer) : null;
    }

    /// <summary>Keeps what was found about freezing for the single frames that follow.</summary>
    private void KeepFreezing(HarvestSession session)
    {
        if (session.Freezing is { } found && found != _freezing)
        {
            _freezing = found;
            _messages.Log($"Freeze = Auto: {found}");
        }
    }

    private void Close(HarvestSession session)
    {
        SessionWriter writer = _writer.Opened!;
        HarvestStatus status = session.Status;
        _session = null;
        _writer.Close();
        _lastWriter = status.Fault is null ? writer : null;
        if (_isSingle && status.Captured > 0)
        {
            _singles = new SingleFrames(writer.Folder, _startedWith!.Lens, _startedWith.Faces!, session.CalibrationErrorPixels);
        }

        Tell(session);
    }

    private void Tell(HarvestSession session)
    {
        HarvestStatus status = session.Status;
        string discards = string.Join(", ",
            session.Counters.Discards.Select(discard => FormattableString.Invariant($"{discard.Value} {discard.Key}")));
        string counts = Counted.Of(status.Captured, "frame")
            + (discards.Length > 0 ? $", discarded: {discards}" : string.Empty);
        if (session.Calls.Phases.Count > 0)
        {
            _messages.Log($"The harvest asked of the game: {session.Calls}");
        }

        foreach (CaptureFault warning in session.Warnings)
        {
            _messages.Tell(HarvestAdvice.TextOf(warning));
        }

        _messages.Tell(session.Failure is { } fault ? $"{HarvestAdvice.TextOf(fault)} ({counts})"
            : $"The harvest ended: {counts}, in {_folder}.");
    }

    /// <summary>The last frames are written when the harvest is over: what the disk refuses then is told when that is known.</summary>
    private void TellLateFault()
    {
        if (_lastWriter is not { } writer || IsBusy)
        {
            return;
        }

        _lastWriter = null;
        if (writer.Fault is { } fault)
        {
            _messages.Tell(fault);
            _singles = null;
        }
    }

    private string NewFolder(string kind)
    {
        string name = Path.Combine(_folder, kind + DateTime.Now.ToString("-yyyyMMdd-HHmmss", CultureInfo.InvariantCulture));
        string free = name;
        for (int number = 2; Directory.Exists(free); number++)
        {
            free = FormattableString.Invariant($"{name}-{number}");
        }

        return free;
    }

    /// <summary>
    /// The session that single frames make together, once it has one. Its camera model is checked until that could be done once.
    /// </summary>
    private sealed record SingleFrames(string Folder, Lens Lens, FaceTable Faces, double? CalibrationErrorPixels);
}
