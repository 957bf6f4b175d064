using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Sessions.Labels;

namespace Harvester.Driving.Session;

/// <summary>
/// The game's side of a drive over a bridge: call <see cref="Tick"/> once in every tick of the game, from the game's own thread. It sends
/// frames at the frame rate, drives the car by the client's messages, and brakes when the client is silent. If the client sends indicators,
/// a controller here turns them into controls. Calls never block, and after construction nothing is thrown to the caller: a fault of a port
/// ends the drive with a message, and so does the player by driving. The caller disposes the bridge.
/// </summary>
public sealed class DrivingSession : IDisposable
{
    private readonly GamePorts _game;
    private readonly IDrivenCar _car;
    private readonly IDrivingBridge _bridge;
    private readonly Func<IController> _newController;
    private readonly bool _isLockStep;
    private readonly SilenceWatch _watch;
    private readonly DrivingView _view;
    private readonly WorldPace _pace;
    private readonly FramePublisher _frames;
    private readonly ClientAgenda _agenda;
    private IController _controller;
    private string? _bridgeProblem;
    private double _nowSeconds;
    private string? _ending;

    /// <summary>Creates a drive. The game is not used before the first tick.</summary>
    /// <param name="options">Frame rate, image size and the time that controls hold.</param>
    /// <param name="game">The game; its car is driven.</param>
    /// <param name="bridge">The bridge to the client, for images of the size in the options. The caller disposes it.</param>
    /// <param name="newController">
    /// Creates the controller that turns a client's indicators into controls; called again after each reset.
    /// </param>
    /// <param name="readTruth">Reads what only a simulated game knows; null in GTA V.</param>
    /// <exception cref="ArgumentNullException">An argument is null, except <paramref name="readTruth"/>.</exception>
    /// <exception cref="ArgumentException">The game has no car that can be driven.</exception>
    public DrivingSession(
        DrivingOptions options,
        GamePorts game,
        IDrivingBridge bridge,
        Func<IController> newController,
        Func<DrivingTruth>? readTruth = null
    )
    {
        _ = options ?? throw new ArgumentNullException(nameof(options));
        _game = game ?? throw new ArgumentNullException(nameof(game));
        _car = game.Car ?? throw new ArgumentException("This game has no car that can be driven.", nameof(game));
        _bridge = bridge ?? throw new ArgumentNullException(nameof(bridge));
        _agenda = new ClientAgenda(bridge, options.IsLockStep, problem => Problem = problem);
        _newController = newController ?? throw new ArgumentNullException(nameof(newController));
        _controller = newController();
        _watch = new SilenceWatch(new WorldClock(game.World), options.PatienceSeconds);
        _view = new DrivingView(game, options.Picture) { ReadTruth = readTruth };
        _isLockStep = options.IsLockStep;
        _pace = new WorldPace(game.Pause, options.SettleTicks, options.IsLockStep);
        _frames = new FramePublisher(options, bridge, _view, _pace);
        Sent = new SentFrames(_frames, _view, _pace);
    }

    /// <summary>The current state of the drive.</summary>
    public DrivingStatus Status { get; private set; }

    /// <summary>The last problem that did not end the drive, as one line; null if there was none.</summary>
    public string? Problem { get; private set; }

    /// <summary>Whether an image may be grabbed in the next ticks, so that overlays must not be drawn now.</summary>
    public bool IsPictureNear => _ending is null && _frames.IsPictureNear;

    /// <summary>Whether the world is running only until the end of a step that the client requested.</summary>
    public bool IsStepping => _pace.IsStepping;

    /// <summary>Whether a client has sent controls recently; otherwise the car brakes.</summary>
    public bool IsClientAlive => _watch.IsClientAlive;

    /// <summary>Number of controls and indicators that were received and that drive the car.</summary>
    public long Answers { get; private set; }

    /// <summary>Number of the frame that the last of them answered; null if the client did not say, or sent none.</summary>
    public long? AnsweredFrame { get; private set; }

    /// <summary>The indicators that the last of them brought; null if it brought controls.</summary>
    public IReadOnlyList<double>? AnsweredIndicators { get; private set; }

    /// <summary>The controller's target for these indicators; null if it brought controls, or if the target is unknown.</summary>
    public DriveTarget? AnsweredTarget { get; private set; }

    /// <summary>Number of times that the client has placed the car elsewhere.</summary>
    public long Resets { get; private set; }

    /// <summary>The frames that are sent.</summary>
    public SentFrames Sent { get; }

    /// <summary>Whether commands of the client wait for the next tick.</summary>
    public bool HasCommands => _agenda.HasCommands;

    /// <summary>The restart that the client asks for; null for none. It takes a new game and drive: this one does nothing more.</summary>
    public RestartMessage? Restart { get; private set; }

    /// <summary>Does the work of one tick. After the end of the drive it does nothing.</summary>
    public DrivingStatus Tick()
    {
        if (_ending is null && Restart is null)
        {
            Try(Drive);
        }

        return Status;
    }

    /// <summary>
    /// Discards what is known of the road, the controller's memory and the current controls. Call it when the game itself has moved the
    /// car.
    /// </summary>
    public void Reset()
    {
        _watch.Reset();
        _view.Reset();
        _controller = _newController();
    }

    /// <summary>
    /// Sends a frame as soon as possible, as if the client had requested it: for a world that is paused until a client drives.
    /// </summary>
    /// <param name="hasPicture">Whether with an image.</param>
    public void AskForFrame(bool hasPicture = true) => _frames.Ask(hasPicture);

    /// <summary>Ends the drive and resumes the world. Further calls do nothing.</summary>
    public void Stop()
    {
        if (_ending is null)
        {
            End("The drive was stopped.");
        }
    }

    /// <summary>Ends the drive like <see cref="Stop"/>.</summary>
    public void Dispose() => Stop();

    private void Drive()
    {
        if (_car.IsTakenByPlayer)
        {
            End("The player has taken the wheel.");
            return;
        }

        _nowSeconds = _game.World.TimeSeconds;
        _frames.BeginTick(_nowSeconds);
        _pace.Tick(_nowSeconds);
        Receive();
        DrivingControls controls = _watch.Controls;
        if (!_isLockStep || _pace.IsStepping)
        {
            // In lock-step, once for each tick of the world, whenever the client's messages arrive.
            _car.Drive(controls);
        }

        Problem = _frames.PublishIfTime() ?? Problem;
        ReadProblem();
        Status = new DrivingStatus(_frames.Frames, _watch.IsClientAlive, controls, _view.AreLanesKnown, null);
    }

    private void Receive()
    {
        if (_agenda.Receive())
        {
            LoseClient();
        }

        while (!_frames.IsStepOpen && Restart is null && _agenda.TryTakeCommand(out ClientMessage? command))
        {
            Apply(command);
        }

        TakeAnswer(_agenda.TakeNewest());
    }

    /// <summary>Discards everything the client requested; the car brakes and the world resumes.</summary>
    private void LoseClient()
    {
        _frames.Clear();
        _controller = _newController();
        _watch.Reset();
        _pace.GoOn();
    }

    private void TakeAnswer(ClientMessage? message)
    {
        if (message is ControlsMessage controls)
        {
            _watch.Receive(controls.Controls);
            Count(controls.Frame, null);
        }
        else if (message is IndicatorsMessage indicators)
        {
            try
            {
                _watch.Receive(_controller.Drive(_view.StateOf(IndicatorOrder.FromValues(indicators.Values))));
                Count(indicators.Frame, indicators.Values);
            }
            catch (ArgumentException exception)
            {
                Problem = exception.Message;
            }
        }
    }

    private void Count(long? answered, IReadOnlyList<double>? indicators)
    {
        Answers++;
        AnsweredFrame = answered;
        AnsweredIndicators = indicators;
        AnsweredTarget = indicators is null ? null : (_controller as IAimingController)?.Target;
    }

    private void Apply(ClientMessage command)
    {
        switch (command)
        {
            case ResetMessage reset:
                _car.Reset(reset.Position, reset.HeadingDegrees);
                _pace.Unsettle();
                Reset();
                Resets++;
                break;
            case EnvironmentMessage environment:
                SetEnvironment(environment);
                break;
            case PauseMessage { IsPaused: true }:
                _pace.Pause();
                break;
            case PauseMessage:
                _pace.GoOn();
                break;
            case StepMessage step:
                _pace.Step(_nowSeconds, step.Seconds);
                _frames.AskAtEndOfStep(step.HasPicture);
                break;
            case RequestFrameMessage request:
                _frames.Ask(request.HasPicture);
                break;
            case RestartMessage restart:
                Restart = restart;
                break;
            default:
                Problem = $"{command.GetType().Name} is not a driving command.";
                break;
        }
    }

    private void SetEnvironment(EnvironmentMessage environment)
    {
        try
        {
            _car.SetEnvironment(environment.Weather, environment.TimeOfDay);
            _pace.Unsettle();
        }
        catch (ArgumentException exception)
        {
            Problem = exception.Message;
        }
    }

    private void ReadProblem()
    {
        if (_bridge.Problem != _bridgeProblem)
        {
            _bridgeProblem = _bridge.Problem;
            Problem = _bridgeProblem;
        }
    }

    private void End(string ending)
    {
        _ending = ending;
        Status = new DrivingStatus(_frames.Frames, false, DrivingControls.Stop, false, ending);
        Try(_pace.Resume);
    }

    private void Try(Action work)
    {
        try
        {
            work();
        }
#pragma warning disable CA1031 // The game's script loop must not see an exception of ours, whatever its type.
        catch (Exception exception)
#pragma warning restore CA1031
        {
            string fault = $"The drive stopped: {exception.Message}";
            if (_ending is null)
            {
                End(fault);
            }
            else
            {
                Status = Status with { Ending = $"{_ending} {fault}" };
            }
        }
    }
}
