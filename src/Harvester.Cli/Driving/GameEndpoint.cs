using System;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Evaluation.Figures;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;

namespace Harvester.Cli.Driving;

/// <summary>A simulated game at the near end of a bridge: pictures and state go out, controls come in.</summary>
internal sealed class GameEndpoint : IDisposable
{
    private readonly SimulatedGame _game;
    private readonly AssistedCar? _assisted;
    private readonly DrivingSession _session;
    private (EgoState Ego, double Seconds) _before;

    /// <summary>Makes ready.</summary>
    /// <param name="game">The game.</param>
    /// <param name="roads">Its roads.</param>
    /// <param name="options">Rate and size of the pictures.</param>
    /// <param name="bridge">To the client.</param>
    /// <param name="newController">Makes what drives by a client's indicators.</param>
    /// <param name="isAssisted">Whether the car's own driver drives through junctions and gives way.</param>
    public GameEndpoint(
        SimulatedGame game, IRoads roads, DrivingOptions options, IDrivingBridge bridge, Func<IController> newController, bool isAssisted)
    {
        _game = game;
        _assisted = isAssisted ? new AssistedCar(game, roads, () => _session!.Status.IsClientAlive) : null;
        GamePorts ports = game.Ports with { Roads = roads, Car = _assisted ?? game.Ports.Car };

        // The picture of the simulated game is never behind.
        _session = new DrivingSession(options with { SettleTicks = 0 }, ports, bridge, newController);
        _before = (game.Ports.World.ReadEgo(), game.Ports.World.TimeSeconds);
    }

    /// <summary>How the drive stands.</summary>
    public DrivingStatus Status => _session.Status;

    /// <summary>The last thing that went wrong without ending the drive, as one line; null when nothing has.</summary>
    public string? Problem => _session.Problem;

    /// <summary>Whether the world goes on only to the end of a step that the client asked for.</summary>
    public bool IsStepping => _session.IsStepping;

    /// <summary>Whether the client drives and not the car's own driver.</summary>
    public bool IsByClient => _assisted?.IsByClient ?? true;

    /// <summary>Metres that the car has driven; where it was put elsewhere it has not.</summary>
    public double Metres { get; private set; }

    /// <summary>Hears the client, and lets the world stand.</summary>
    public DrivingStatus Listen()
    {
        DrivingStatus status = _session.Tick();
        _before = (_game.Ports.World.ReadEgo(), _game.Ports.World.TimeSeconds);
        return status;
    }

    /// <summary>Lets the world go on, unless it is stopped, and hears the client.</summary>
    public DrivingStatus Tick(double seconds)
    {
        _game.Tick(seconds);
        EgoState now = _game.Ports.World.ReadEgo();
        double metres = (now.Pose.Position - _before.Ego.Pose.Position).Length;
        if (Relocation.Is(metres, _before.Ego.Velocity.Length, now.Velocity.Length, _game.Ports.World.TimeSeconds - _before.Seconds))
        {
            _assisted?.Forget();
            _session.Forget();
        }
        else
        {
            Metres += metres;
        }

        return Listen();
    }

    /// <summary>Sends a frame as soon as there is one, as if the client had asked for it.</summary>
    public void ShowAgain() => _session.AskForFrame();

    public void Dispose() => _session.Dispose();
}
