using System;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Sessions.Labels;

namespace Harvester.Driving.Session;

/// <summary>
/// The game's side of a drive over a bridge: call <see cref="Tick"/> once in every tick of the game, from the game's own thread. It
/// sends frames at their rate, drives the car by what the client says, and brakes when the client is silent. Where the client sends
/// indicators, a controller here makes controls of them. Nothing waits, and nothing is thrown to the caller after construction: a fault of
/// a port ends the drive with a sentence, and so does the player at the wheel. The bridge stays its maker's to dispose.
/// </summary>
public sealed class DrivingSession : IDisposable
{
    private readonly GamePorts _game;
    private readonly IDrivenCar _car;
    private readonly IDrivingBridge _bridge;
    private readonly Func<IController> _newController;
    private readonly SilenceWatch _watch;
    private readonly DrivingView _view;
    private readonly WorldPace _pace;
    private readonly FramePublisher _frames;
    private readonly ClientAgenda _agenda;
    private IController _controller;
    private string? _bridgeProblem;
    private double _nowSeconds;
    private string? _ending;

    /// <summary>Makes a drive; nothing is asked of the game before the first tick.</summary>
    /// <param name="options">How.</param>
    /// <param name="game">The game, with a car that can be driven.</param>
    /// <param name="bridge">To the client; made for pictures of the size in the options.</param>
    /// <param name="newController">Makes what drives by the indicators that a client sends; asked again after each reset.</param>
    /// <exception cref="ArgumentException">The game has no car that can be driven.</exception>
    public DrivingSession(DrivingOptions options, GamePorts game, IDrivingBridge bridge, Func<IController> newController)
    {
        if (options is null)
        {
            throw new ArgumentNullException(nameof(options));
        }

        _game = game ?? throw new ArgumentNullException(nameof(game));
        _car = game.Car ?? throw new ArgumentException("This game has no car that can be driven.", nameof(game));
        _bridge = bridge ?? throw new ArgumentNullException(nameof(bridge));
        _agenda = new ClientAgenda(bridge, problem => Problem = problem);
        _newController = newController ?? throw new ArgumentNullException(nameof(newController));
        _controller = newController();
        _watch = new SilenceWatch(new WorldClock(game.World), options.PatienceSeconds);
        _view = new DrivingView(game, options.Picture);
        _pace = new WorldPace(game.Pause, options.SettleTicks);
        _frames = new FramePublisher(options, bridge, _view, _pace);
    }

    /// <summary>The drive as it stands.</summary>
    public DrivingStatus Status { get; private set; }

    /// <summary>The last thing that went wrong without ending the drive, as one line; null when nothing has.</summary>
    public string? Problem { get; private set; }

    /// <summary>Whether a picture may be grabbed so soon that nothing may be drawn now that does not belong into it.</summary>
    public bool IsPictureNear => _ending is null && _frames.IsPictureNear;

    /// <summary>Whether the world goes on only to the end of a step that a client asked for.</summary>
    public bool IsStepping => _pace.IsStepping;

    /// <summary>Does one tick's share of the drive. After the end it does nothing.</summary>
    public DrivingStatus Tick()
    {
        if (_ending is null)
        {
            Try(Drive);
        }

        return Status;
    }

    /// <summary>Forgets the road, what the controller knew of it and the controls that hold: for a game that has itself put the car elsewhere.</summary>
    public void Forget()
    {
        _watch.Forget();
        _view.Forget();
        _controller = _newController();
    }

    /// <summary>Sends a frame as soon as there is one, as if the client had asked for it: for a world that stands until somebody drives.</summary>
    public void AskForFrame() => _frames.Ask();

    /// <summary>Ends the drive and lets the world go on. Again is no harm.</summary>
    public void Stop()
    {
        if (_ending is null)
        {
            End("The drive was stopped.");
        }
    }

    /// <summary>Stops.</summary>
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
        _car.Drive(controls);
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

        while (!_frames.IsStepOpen && _agenda.TryTakeCommand(out ClientMessage? command))
        {
            Obey(command);
        }

        Hear(_agenda.TakeNewest());
    }

    /// <summary>As if the client had never been: what it asked for is void, the car brakes and the world goes on.</summary>
    private void LoseClient()
    {
        _frames.Forget();
        _controller = _newController();
        _watch.Forget();
        _pace.GoOn();
    }

    private void Hear(ClientMessage? message)
    {
        if (message is ControlsMessage controls)
        {
            _watch.Hear(controls.Controls);
        }
        else if (message is IndicatorsMessage indicators)
        {
            try
            {
                _watch.Hear(_controller.Drive(_view.StateOf(IndicatorOrder.FromValues(indicators.Values))));
            }
            catch (ArgumentException exception)
            {
                Problem = exception.Message;
            }
        }
    }

    private void Obey(ClientMessage command)
    {
        switch (command)
        {
            case ResetMessage reset:
                _car.Reset(reset.Position, reset.HeadingDegrees);
                Forget();
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
                _frames.AskAtEndOfStep();
                break;
            case RequestFrameMessage:
                _frames.Ask();
                break;
            default:
                Problem = $"{command.GetType().Name} is no command of a drive.";
                break;
        }
    }

    private void SetEnvironment(EnvironmentMessage environment)
    {
        try
        {
            _car.SetEnvironment(environment.Weather, environment.TimeOfDay);
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
        Try(_pace.GoOn);
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
