using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Driving.Recording;
using Harvester.Driving.Session;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Play.Features;

/// <summary>
/// Records what a client drives over the bridge as a session: the frames that it is sent, with their labels and its answers. The session
/// begins with the first frame for a client. Nothing waits for the disk: frames for which it has no room are left out. A fault ends the
/// recording with a message, and the drive goes on.
/// </summary>
public sealed class BridgeRecording
{
    /// <summary>Fraction of the time between two recorded frames by which one may be early, since frames are sent in whole ticks.</summary>
    private const double EarlyFraction = 0.25;

    private readonly int _lagTicks;
    private readonly HarvestOptions _options;
    private readonly string _folder;
    private readonly PlayerMessages _messages;
    private readonly GamePorts _game;
    private readonly PlayerCar _car;
    private readonly Func<SessionOrigin> _origin;
    private readonly SentPicture _picture = new();
    private readonly SlowResource<SessionWriter> _writer = new();
    private DriveRecorder? _recorder;
    private SessionWriter? _lastWriter;
    private bool _isOver;
    private bool _hasSentWithoutImage;
    private int _leftOut;
    private double _leftOutSeconds = double.NegativeInfinity;
    private double _lastSeconds;
    private long _answers;
    private long _resets;
    private long _frames;

    /// <summary>Creates a recording; nothing is recorded before the first drive.</summary>
    /// <param name="rateHz">Maximum number of recorded frames per second of game time; greater than 0.</param>
    /// <param name="labels">What is labelled and how images are written; their size is that of the images that are sent.</param>
    /// <param name="folder">The folder of the sessions, each in a folder of its own.</param>
    /// <param name="messages">Reports how recordings ended.</param>
    /// <param name="game">The game.</param>
    /// <param name="car">The car that is driven.</param>
    /// <param name="origin">Returns the origin of a session at its start.</param>
    /// <param name="lagTicks">Number of ticks by which the picture of a running game lags behind its entities, 0 or more.</param>
    public BridgeRecording(
        double rateHz,
        HarvestOptions labels,
        string folder,
        PlayerMessages messages,
        GamePorts game,
        PlayerCar car,
        Func<SessionOrigin> origin,
        int lagTicks = 0
    )
    {
        // The game reports the pose of an attached camera a tick late, so the picture is one tick less behind it.
        _lagTicks = lagTicks;
        _options = DriveRecorder.Options(rateHz, labels) with
        {
            EarlyFraction = EarlyFraction,
            LiveLag = new PictureLag(Math.Max(0, lagTicks - 1), lagTicks),
        };
        _folder = folder;
        _messages = messages;
        _game = game with { Screen = _picture, Pause = new NoPause() };
        _car = car;
        _origin = origin;
    }

    /// <summary>The faces of signs and heads of lights in use now.</summary>
    public Func<FaceTable> FacesInUse { get; init; } = static () => FaceTable.Empty;

    /// <summary>Whether a session is being opened or written.</summary>
    public bool IsBusy => _writer.IsBusy;

    /// <summary>Number of frames of the running recording; null if none is running.</summary>
    public int? Frames => _recorder?.Frames;

    /// <summary>Allows the recording of a drive, which begins with the first frame for a client.</summary>
    public void Begin() => (_isOver, _leftOut, _leftOutSeconds, _hasSentWithoutImage) = (false, 0, double.NegativeInfinity, false);

    /// <summary>Records the tick that has passed. Call it before the drive does its work of this tick.</summary>
    /// <param name="drive">The drive.</param>
    public void BeforeTick(DrivingSession drive)
    {
        _ = drive ?? throw new ArgumentNullException(nameof(drive));
        (_answers, _frames, _resets) = (drive.Answers, drive.Status.Frames, drive.Resets);
        drive.Sent.LeadTicks = _recorder is null ? 0 : _lagTicks;
        if (_recorder is { } recorder)
        {
            Try(() => RecordTick(recorder, drive.Status.IsClientAlive ? DriverKind.Client : DriverKind.None));
        }
    }

    /// <summary>Records the answers and the frame of this tick. Call it after the drive has done its work of it.</summary>
    /// <param name="drive">The drive.</param>
    /// <param name="hasClient">Whether there is a client.</param>
    public void AfterTick(DrivingSession drive, bool hasClient)
    {
        _ = drive ?? throw new ArgumentNullException(nameof(drive));
        if (!_isOver)
        {
            Try(() => RecordAnswerAndFrame(drive, hasClient));
        }
    }

    /// <summary>Reports an error of the disk that was found after the end. Call it in every tick.</summary>
    public void TellLateFault()
    {
        if (_lastWriter is not { } writer || IsBusy)
        {
            return;
        }

        _lastWriter = null;
        if (writer.Fault is { } fault)
        {
            _messages.Tell(fault);
        }
    }

    /// <summary>Ends the recording and reports the number of frames. Calling it again has no effect.</summary>
    public void Stop()
    {
        if (!_isOver && _writer.IsHeld)
        {
            End(null);
        }
        else if (!_isOver && _hasSentWithoutImage)
        {
            _isOver = true;
            _messages.Tell("The drive was not recorded: the client asked for frames without images.");
        }
    }

    /// <summary>Waits until everything recorded is on disk, or until the time is over.</summary>
    public void Wait(TimeSpan timeout)
    {
        _writer.Wait(timeout);
        TellLateFault();
    }

    private void RecordTick(DriveRecorder recorder, DriverKind driver)
    {
        // In a tick in which the player has taken the wheel, it was not the client who drove.
        if (_game.World.TimeSeconds != _lastSeconds && !_car.IsTakenByPlayer)
        {
            recorder.Tick(driver, applied: _car.InForce);
        }
    }

    private void RecordAnswerAndFrame(DrivingSession drive, bool hasClient)
    {
        if (_recorder is { } recorder && drive.Answers != _answers)
        {
            recorder.Answer(drive.Status.Controls, drive.AnsweredIndicators, drive.AnsweredTarget, drive.AnsweredFrame);
        }

        if (drive.Resets != _resets)
        {
            _recorder?.Reset();
        }

        bool isForClient = drive.Status.Frames != _frames && hasClient;
        bool isSent = isForClient && drive.Sent.Picture is not null;
        _hasSentWithoutImage |= isForClient && !isSent;
        _picture.Picture = isSent ? drive.Sent.Picture : null;
        if (_writer.TakeFailure() is { } failure)
        {
            End($"The session of the drive cannot be begun: {failure.Message}");
        }
        else if (_writer.Opened is { } writer)
        {
            _recorder ??= new DriveRecorder(_options with { Faces = FacesInUse() }, _game, writer, null);
            Look(_recorder, writer, drive, isSent, hasClient);
        }
        else if (isSent && !_writer.IsHeld)
        {
            SessionOrigin origin = _origin();
            _writer.Open(() => SessionPlace.Locked(SessionPlace.NewIn(_folder, "drive"), origin));
        }

        _lastSeconds = _game.World.TimeSeconds;
    }

    private void Look(DriveRecorder recorder, SessionWriter writer, DrivingSession drive, bool isSent, bool hasClient)
    {
        long frame = drive.Status.Frames - 1;
        bool isForeseen = hasClient && drive.Sent.IsForeseen;
        double now = _game.World.TimeSeconds;

        // With a lag, the picture of a running game does not show the present state.
        bool isPresent = isSent && (_lagTicks == 0 || drive.Sent.IsWorldPaused);
        if (recorder.IsFollowing)
        {
            recorder.Follow(frame);
        }
        else if ((isForeseen || isPresent) && writer.Queued >= Math.Max(1, _options.QueueCapacity - 1))
        {
            // A place is kept for the frame that waits for its action.
            // Of the frames that are sent, not all are to be recorded.
            if (now - _leftOutSeconds >= (1 - EarlyFraction) / _options.RateHz)
            {
                _leftOut++;
                _leftOutSeconds = now;
            }
        }
        else if (isForeseen)
        {
            recorder.Begin();
        }
        else if (isPresent)
        {
            recorder.Look(frame);
        }

        if (recorder.Failure is { } failure)
        {
            End(HarvestAdvice.TextOf(failure));
        }
    }

    private void Try(Action work)
    {
        try
        {
            work();
        }
#pragma warning disable CA1031 // Whatever fails here must not end the drive.
        catch (Exception exception) when (exception is not ThreadAbortException)
#pragma warning restore CA1031
        {
            _messages.Log(exception.ToString());
            End($"The recording failed: {exception.Message}");
        }
    }

    private void End(string? fault)
    {
        int frames = _recorder?.Frames ?? 0;
        _isOver = true;
        _recorder?.Dispose();
        _recorder = null;
        _lastWriter = fault is null ? _writer.Opened : null;
        _writer.Close();
        string leftOut = _leftOut > 0 ? $", {_leftOut} left out because the disk was busy" : "";
        _messages.Tell(
            fault is null
                ? $"The drive was recorded: {Counted.Of(frames, "frame")}{leftOut}, in {_folder}."
                : $"{fault.TrimEnd('.')}. The drive goes on without a recording."
        );
    }
}
