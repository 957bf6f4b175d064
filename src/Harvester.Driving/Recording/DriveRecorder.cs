using Harvester.Capture.Faults;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Driving.Recording;

/// <summary>
/// Records a drive as a session: frames with their labels, and for each frame the action that answered it. The world moves between the
/// calls; a frame shows the world as it is when <see cref="Look"/> takes it. Nothing is thrown to the caller after construction; a fault of
/// a port or of the sink ends the recording.
/// </summary>
public sealed class DriveRecorder : IDisposable
{
    private readonly HarvestSession _session;
    private readonly HeldSink _held;
    private readonly IWorld _world;
    private readonly Func<DrivingTruth>? _readTruth;
    private readonly InertialSensor _inertia = new();
    private readonly MotionRecorder _motion;
    private readonly PictureLag _lag;
    private IReadOnlyList<MotionSample> _motionToFrame = [];
    private PictureLag _nextLag;
    private bool _isDisplaced;
    private bool _isStarted;
    private bool _isStepping;
    private OpenAction? _begun;
    private OpenAction? _action;

    /// <summary>Creates a recorder. The game is not used before the first frame.</summary>
    /// <param name="options">A live harvest with a known picture lag, without masks; its rate limits that of the frames.</param>
    /// <param name="game">The game.</param>
    /// <param name="sink">Receives the frames; the caller disposes it.</param>
    /// <param name="readTruth">Reads what only a simulated game knows; null in GTA V.</param>
    /// <exception cref="ArgumentNullException">An argument is null, except <paramref name="readTruth"/>.</exception>
    public DriveRecorder(HarvestOptions options, GamePorts game, IFrameSink sink, Func<DrivingTruth>? readTruth)
    {
        _world = (game ?? throw new ArgumentNullException(nameof(game))).World;
        _readTruth = readTruth;
        _motion = new MotionRecorder(_world);
        _held = new HeldSink(sink ?? throw new ArgumentNullException(nameof(sink)), Complete);
        _session = new HarvestSession(options, game, _held) { NextLag = () => _nextLag };
        _lag = options?.LiveLag ?? default;
    }

    /// <summary>Options of a recording.</summary>
    /// <param name="rateHz">Maximum number of frames per second of game time; greater than 0.</param>
    /// <param name="labels">What is labelled and how images are written; null for the defaults.</param>
    public static HarvestOptions Options(double rateHz, HarvestOptions? labels = null) =>
        (labels ?? new()) with
        {
            RateHz = rateHz,
            Freeze = false,
            LiveLag = new PictureLag(0, 0),
            ProbeLag = false,
            MaxCalibrationErrorPixels = null,
            MaxPictureLagTicks = 0,
            MaxFrames = null,
            Motion = true,
            Scenes = false,
            Masks = false,
            Semantics = null,
            Channels = ChannelKeys.None,
            Pairs = new PairOptions(),
            Rig = null,
        };

    /// <summary>Why the recording ended early; null if it did not.</summary>
    public CaptureFault? Failure => _session.Failure;

    /// <summary>Number of frames taken.</summary>
    public int Frames => _held.Received;

    /// <summary>Whether a frame has been begun whose picture is still to come.</summary>
    public bool IsFollowing => _session.Status.Phase == HarvestPhase.Following;

    /// <summary>Takes a frame of the world as it is now, if the rate allows one. The picture shows the world as it is.</summary>
    /// <param name="bridgeFrame">Number of the frame on the live bridge that shows the same; null without a bridge.</param>
    /// <returns>Whether a frame was taken.</returns>
    public bool Look(long? bridgeFrame = null) => Start(new PictureLag(0, 0), bridgeFrame);

    /// <summary>
    /// Begins a frame of the world as it is now, if the rate allows one. The picture that shows it comes later, by the entities' lag of the
    /// options: call <see cref="Follow"/> in each of these ticks.
    /// </summary>
    public void Begin() => Start(_lag, null);

    /// <summary>Goes on with a frame that was begun.</summary>
    /// <param name="bridgeFrame">Number of the frame on the live bridge that shows the same; null without a bridge.</param>
    /// <returns>Whether the frame was taken.</returns>
    public bool Follow(long? bridgeFrame = null) => Step(_begun!, bridgeFrame);

    /// <summary>Records what a controller or client answered to the newest frame; later answers are ignored until the next frame.</summary>
    /// <param name="controls">The controls, without disturbance.</param>
    /// <param name="indicators">The thirteen indicators by which they were found, scaled to TORCS; null if there were none.</param>
    /// <param name="target">The controller's target; null if it is unknown.</param>
    /// <param name="bridgeFrame">Number of the answered frame on the live bridge; null if unknown.</param>
    public void Answer(DrivingControls controls, IReadOnlyList<double>? indicators, DriveTarget? target = null, long? bridgeFrame = null) =>
        _action?.Answer(controls, indicators, target, bridgeFrame, _world.TimeSeconds);

    /// <summary>Discards the motion of the car: it has been placed elsewhere since the last tick.</summary>
    public void Reset()
    {
        _inertia.Reset();
        _isDisplaced = true;
    }

    /// <summary>Records a tick in which the world has moved.</summary>
    /// <param name="driver">Who drove in it.</param>
    /// <param name="isDisturbed">Whether the steering was disturbed in it.</param>
    /// <param name="applied">The controls that moved the car in it, for a game whose car does not report them; null if unknown.</param>
    public void Tick(DriverKind driver, bool isDisturbed = false, DriveControls? applied = null)
    {
        EgoState ego = _world.ReadEgo();
        _motion.Record();
        _session.Observe();
        _inertia.Measure(ego, _world.TimeSeconds);
        (_action ?? _begun)?.Add(
            new DriveTick(_world.TimeSeconds, ego.Velocity.Length, driver)
            {
                Acceleration = _inertia.Acceleration,
                AngularRate = _inertia.AngularRate,
                Applied = ego.Motion is { Steering: { } steering, Throttle: { } throttle, Brake: { } brake }
                    ? new DriveControls(steering, throttle, brake)
                    : applied,
            },
            isDisturbed
        );
    }

    /// <summary>Ends the recording and closes the sink.</summary>
    public void Dispose() => _session.Dispose();

    private bool Start(PictureLag lag, long? bridgeFrame)
    {
        EgoState ego = _world.ReadEgo();
        double now = _world.TimeSeconds;
        if (!_isStarted)
        {
            _inertia.Measure(ego, now);
            _isStarted = true;
        }

        _nextLag = lag;
        _begun = new OpenAction(now, ego.Velocity.Length) { Inertia = (_inertia.Acceleration, _inertia.AngularRate) };
        return Step(_begun, bridgeFrame);
    }

    private bool Step(OpenAction begun, long? bridgeFrame)
    {
        int before = _held.Received;
        _isStepping = true;
        _session.Step();
        _isStepping = false;
        if (_held.Received == before)
        {
            if (!_isDisplaced && _action is { } action && action.TimeSeconds == begun.TimeSeconds)
            {
                action.RepeatedAs = bridgeFrame;
            }

            return false;
        }

        _isDisplaced = false;

        IReadOnlyList<MotionSample> motion = _motion.TakeBefore(begun.TimeSeconds);
        _motionToFrame = before == 0 ? [] : motion;
        begun.BridgeFrame = bridgeFrame;
        begun.Truth = _readTruth?.Invoke();
        _action = begun;
        return true;
    }

    private void Complete(CapturedFrame frame)
    {
        // The ticks since the next frame are those of its action; without one, the session ends.
        if (_isStepping)
        {
            _action!.MoveTicksTo(_begun!, _begun!.TimeSeconds);
        }

        frame.Attach(_action!.Label(), _motionToFrame);
    }
}
