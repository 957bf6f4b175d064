using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Runs.Evaluation.Figures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;

namespace Harvester.Runs.Driving;

/// <summary>The game's side of a bridge, with the simulated game: sends images and state, receives controls.</summary>
public sealed class GameEndpoint : IDisposable
{
    private readonly SimulatedGame _game;
    private readonly IDrivingBridge _bridge;
    private readonly AssistedCar? _assisted;
    private readonly DrivingSession _session;
    private (EgoState Ego, double Seconds) _before;

    /// <summary>Connects a game to a bridge.</summary>
    /// <param name="game">The game.</param>
    /// <param name="roads">Its roads.</param>
    /// <param name="options">Rate and size of the images.</param>
    /// <param name="bridge">The bridge to the client.</param>
    /// <param name="newController">Creates the controller for indicators that a client sends.</param>
    /// <param name="isAssisted">Whether the built-in driver drives through junctions and gives way.</param>
    public GameEndpoint(
        SimulatedGame game,
        IRoads roads,
        DrivingOptions options,
        IDrivingBridge bridge,
        Func<IController> newController,
        bool isAssisted
    )
    {
        (_game, _bridge) = (game, bridge);
        _assisted = isAssisted ? new AssistedCar(game, roads, () => _session!.IsClientAlive) : null;
        GamePorts ports = game.Ports with { Roads = roads, Car = _assisted ?? game.Ports.Car };

        // The image of the simulated game never lags.
        _session = new DrivingSession(
            options with
            {
                SettleTicks = 0,
            },
            ports,
            bridge,
            newController,
            () => TruthReader.Of(game, !IsByClient)
        );
        _ = game.Conduct;
        _before = (game.Ports.World.ReadEgo(), game.Ports.World.TimeSeconds);
    }

    /// <summary>Records the drive; null for none. It is finished with the endpoint.</summary>
    public GameRecording? Recording
    {
        get;
        init
        {
            field = value;
            value?.IsByBuiltInDriver = () => !IsByClient;
        }
    }

    /// <summary>Status of the driving session.</summary>
    public DrivingStatus Status => _session.Status;

    /// <summary>The last problem that did not end the drive, one line; null if there has been none.</summary>
    public string? Problem => _session.Problem;

    /// <summary>Whether the world runs only until the end of a step that the client requested.</summary>
    public bool IsStepping => _session.IsStepping;

    /// <summary>Whether commands of the client wait for the next tick.</summary>
    public bool HasCommands => _session.HasCommands;

    /// <summary>The restart that the client asks for, which takes a new game and endpoint; null for none.</summary>
    public RestartMessage? Restart => _session.Restart;

    /// <summary>Whether the client drives, not the built-in driver.</summary>
    public bool IsByClient => _assisted?.IsByClient ?? true;

    /// <summary>Distance driven, metres, without teleports.</summary>
    public double Metres { get; private set; }

    /// <summary>Advances the world, unless it is frozen, and handles messages of the client.</summary>
    /// <param name="seconds">Game time to advance; 0 to handle messages only.</param>
    /// <exception cref="System.IO.IOException">The recording cannot be written.</exception>
    public DrivingStatus Tick(double seconds)
    {
        if (seconds > 0)
        {
            _game.Tick(seconds);
            NoteMotion();
        }

        long answers = _session.Answers;
        long frames = _session.Status.Frames;
        long resets = _session.Resets;

        // One that has been sent its last frame may be gone before it is recorded.
        bool hasClient = _bridge.Client is not null;
        DrivingStatus status = _session.Tick();
        if (_session.Resets != resets)
        {
            Recording?.Reset();
        }

        if (_session.Answers != answers)
        {
            Recording?.Answer(status.Controls, _session.AnsweredIndicators, _session.AnsweredTarget, _session.AnsweredFrame);
        }

        if (status.Frames != frames && (hasClient || _bridge.Client is not null))
        {
            Recording?.Look(status.Frames - 1);
        }

        _before = (_game.Ports.World.ReadEgo(), _game.Ports.World.TimeSeconds);
        return status;
    }

    /// <summary>Sends a frame as soon as possible, as if the client had requested it.</summary>
    /// <param name="hasPicture">Whether with an image.</param>
    public void RequestFrame(bool hasPicture = true) => _session.AskForFrame(hasPicture);

    /// <summary>Closes the driving session and its recording.</summary>
    public void Dispose()
    {
        _session.Dispose();
        Recording?.Dispose();
    }

    /// <summary>Records the tick of the world, and notices whether the game has moved the car elsewhere.</summary>
    private void NoteMotion()
    {
        if (_game.Ports.World.TimeSeconds != _before.Seconds)
        {
            Recording?.Tick(
                !IsByClient ? DriverKind.BuiltIn
                : Status.IsClientAlive ? DriverKind.Client
                : DriverKind.None
            );
        }

        EgoState now = _game.Ports.World.ReadEgo();
        double metres = (now.Pose.Position - _before.Ego.Pose.Position).Length;
        if (Relocation.Is(metres, _before.Ego.Velocity.Length, now.Velocity.Length, _game.Ports.World.TimeSeconds - _before.Seconds))
        {
            _assisted?.Reset();
            _session.Reset();
        }
        else
        {
            Metres += metres;
        }
    }
}
