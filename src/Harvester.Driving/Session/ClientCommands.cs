using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Sessions.Labels;

namespace Harvester.Driving.Session;

/// <summary>
/// Does what the client asks. Commands come in order, and wait for the end of a step; of controls and indicators only the newest counts. A
/// reset voids those sent before it; those sent after it wait until it is done.
/// </summary>
/// <param name="options">Whether the game can be restarted; a restart is refused otherwise.</param>
/// <param name="car">The car.</param>
/// <param name="inbox">Messages of the client.</param>
/// <param name="pace">Pauses and resumes the world.</param>
/// <param name="view">What the client sees.</param>
/// <param name="watch">Holds the controls.</param>
/// <param name="newController">Creates the controller that turns indicators into controls.</param>
/// <param name="report">Receives a message for each fault of the client.</param>
internal sealed class ClientCommands(
    DrivingOptions options,
    IDrivenCar car,
    IClientInbox inbox,
    FramePace pace,
    DrivingView view,
    SilenceWatch watch,
    Func<IController> newController,
    Action<string> report
)
{
    /// <summary>Limits the work of a tick if a client sends faster than the game ticks.</summary>
    private const int MaxMessagesPerTick = 300;

    private readonly MessageQueue _messages = new();
    private IController _controller = newController();
    private bool _isRestartWaiting;

    /// <summary>Whether commands wait for the next tick.</summary>
    public bool HasCommands => _messages.HasCommands;

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

    /// <summary>The restart that the client asks for; null for none.</summary>
    public RestartMessage? Restart { get; private set; }

    /// <summary>
    /// Takes the messages that the bridge has received, up to a restart, because what comes after that is meant for the drive that follows;
    /// then runs the commands that may run now, and takes the newest controls or indicators.
    /// </summary>
    public void Run()
    {
        for (
            int taken = 0;
            (!_isRestartWaiting || inbox.HasClientGone) && taken < MaxMessagesPerTick && inbox.TryReceive(out ClientMessage? message);
            taken++
        )
        {
            switch (message)
            {
                case ClientGoneMessage:
                    LoseClient();
                    break;
                case RestartMessage when !options.IsLockStep:
                    report(BridgeProtocol.NoRestart);
                    break;
                default:
                    Keep(message);
                    break;
            }
        }

        while (!pace.IsStepOpen && Restart is null && _messages.TryTakeCommand(out ClientMessage? command))
        {
            switch (command)
            {
                case ResetMessage reset:
                    car.Reset(reset.Position, reset.HeadingDegrees);
                    pace.Unsettle();
                    Reset();
                    Resets++;
                    break;
                case EnvironmentMessage environment:
                    SetEnvironment(environment);
                    break;
                case PauseMessage { IsPaused: true }:
                    pace.Pause();
                    break;
                case PauseMessage:
                    pace.GoOn();
                    break;
                case StepMessage step:
                    pace.Step(step.Seconds, step.HasPicture);
                    break;
                case RequestFrameMessage request:
                    pace.Ask(request.HasPicture);
                    break;
                case RestartMessage restart:
                    Restart = restart;
                    break;
                default:
                    report($"{command.GetType().Name} is not a driving command.");
                    break;
            }
        }

        if (_messages.Resets == 0)
        {
            TakeAnswer(_messages.TakeNewest());
        }
    }

    /// <summary>Discards what is known of the road, the controller's memory and the current controls.</summary>
    public void Reset()
    {
        watch.Reset();
        view.Reset();
        _controller = newController();
    }

    private void Keep(ClientMessage message)
    {
        if (_messages.TryAdd(message))
        {
            _isRestartWaiting |= message is RestartMessage;
        }
        else
        {
            report("the client sends commands faster than they can be executed; the newest are dropped.");
        }
    }

    /// <summary>Discards everything the client requested; the car brakes and the world resumes.</summary>
    private void LoseClient()
    {
        _messages.Clear();
        _isRestartWaiting = false;
        pace.Clear();
        _controller = newController();
        watch.Reset();
        pace.GoOn();
    }

    private void SetEnvironment(EnvironmentMessage environment)
    {
        try
        {
            car.SetEnvironment(environment.Weather, environment.TimeOfDay);
            pace.Unsettle();
        }
        catch (ArgumentException exception)
        {
            report(exception.Message);
        }
    }

    private void TakeAnswer(ClientMessage? message)
    {
        if (message is ControlsMessage controls)
        {
            watch.Receive(controls.Controls);
            Count(controls.Frame, null);
        }
        else if (message is IndicatorsMessage indicators)
        {
            try
            {
                watch.Receive(_controller.Drive(view.StateOf(IndicatorOrder.FromValues(indicators.Values))));
                Count(indicators.Frame, indicators.Values);
            }
            catch (ArgumentException exception)
            {
                report(exception.Message);
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
}
