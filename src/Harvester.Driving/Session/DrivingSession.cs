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
    private readonly bool _isLockStep;
    private readonly SilenceWatch _watch;
    private readonly DrivingView _view;
    private readonly FramePace _pace;
    private readonly ClientCommands _commands;
    private string? _bridgeProblem;
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
        _ = newController ?? throw new ArgumentNullException(nameof(newController));
        _watch = new SilenceWatch(new WorldClock(game.World), options.PatienceSeconds);
        _view = new DrivingView(game, options.Picture) { ReadTruth = readTruth };
        _isLockStep = options.IsLockStep;
        _pace = new FramePace(options, game.Pause, bridge, _view);
        _commands = new ClientCommands(options, _car, bridge.Inbox, _pace, _view, _watch, newController, problem => Problem = problem);
        Sent = new SentFrames(_pace, _view);
    }

    /// <summary>The current state of the drive.</summary>
    public DrivingStatus Status { get; private set; }

    /// <summary>The last problem that did not end the drive, as one line; null if there was none.</summary>
    public string? Problem { get; private set; }

    /// <summary>Whether an image may be grabbed in the next ticks, so that overlays must not be drawn now.</summary>
    public bool IsPictureNear => _ending is null && _pace.IsPictureNear;

    /// <summary>Whether the world is running only until the end of a step that the client requested.</summary>
    public bool IsStepping => _pace.IsStepping;

    /// <summary>Whether a client has sent controls recently; otherwise the car brakes.</summary>
    public bool IsClientAlive => _watch.IsClientAlive;

    /// <summary>Number of controls and indicators that were received and that drive the car.</summary>
    public long Answers => _commands.Answers;

    /// <summary>Number of the frame that the last of them answered; null if the client did not say, or sent none.</summary>
    public long? AnsweredFrame => _commands.AnsweredFrame;

    /// <summary>The indicators that the last of them brought; null if it brought controls.</summary>
    public IReadOnlyList<double>? AnsweredIndicators => _commands.AnsweredIndicators;

    /// <summary>The controller's target for these indicators; null if it brought controls, or if the target is unknown.</summary>
    public DriveTarget? AnsweredTarget => _commands.AnsweredTarget;

    /// <summary>Number of times that the client has placed the car elsewhere.</summary>
    public long Resets => _commands.Resets;

    /// <summary>The frames that are sent.</summary>
    public SentFrames Sent { get; }

    /// <summary>Whether commands of the client wait for the next tick.</summary>
    public bool HasCommands => _commands.HasCommands;

    /// <summary>The restart that the client asks for; null for none. It takes a new game and drive: this one does nothing more.</summary>
    public RestartMessage? Restart => _commands.Restart;

    /// <summary>Does the work of one tick. After the end of the drive it does nothing.</summary>
    public DrivingStatus Tick()
    {
        if (_ending is not null || Restart is not null)
        {
            return Status;
        }

        try
        {
            if (_car.IsTakenByPlayer)
            {
                End("The player has taken the wheel.");
                return Status;
            }

            _pace.BeginTick(_game.World.TimeSeconds);
            _commands.Run();
            DrivingControls controls = _watch.Controls;
            if (!_isLockStep || _pace.IsStepping)
            {
                // In lock-step, once for each tick of the world, whenever the client's messages arrive.
                _car.Drive(controls);
            }

            Problem = _pace.Publish() ?? Problem;
            ReadProblem();
            Status = new DrivingStatus(_pace.Frames, _watch.IsClientAlive, controls, _view.AreLanesKnown, null);
        }
#pragma warning disable CA1031 // The game's script loop must not see an exception of ours, whatever its type.
        catch (Exception exception)
#pragma warning restore CA1031
        {
            Fail(exception);
        }

        return Status;
    }

    /// <summary>
    /// Discards what is known of the road, the controller's memory and the current controls. Call it when the game itself has moved the
    /// car.
    /// </summary>
    public void Reset() => _commands.Reset();

    /// <summary>
    /// Sends a frame as soon as possible, as if the client had requested it: for a world that is paused until a client drives.
    /// </summary>
    /// <param name="hasPicture">Whether with an image.</param>
    public void AskForFrame(bool hasPicture = true) => _pace.Ask(hasPicture);

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
        Status = new DrivingStatus(_pace.Frames, false, DrivingControls.Stop, false, ending);
        try
        {
            _pace.Resume();
        }
#pragma warning disable CA1031 // As in Tick.
        catch (Exception exception)
#pragma warning restore CA1031
        {
            Fail(exception);
        }
    }

    private void Fail(Exception exception)
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
