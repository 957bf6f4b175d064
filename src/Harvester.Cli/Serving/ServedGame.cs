using System;
using System.Diagnostics;
using System.Threading;
using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Bridge;
using Harvester.Capture.Driving.Controllers;
using Harvester.Capture.Ports;
using Harvester.Cli.Harvesting;
using Harvester.Geometry;
using Harvester.Simulation;

namespace Harvester.Cli.Serving;

/// <summary>A simulated game at the pace of the clock on the wall, for a peer at the other end of a bridge. The steps that a peer asks for are taken as fast as it goes.</summary>
internal sealed class ServedGame : IDisposable
{
    private const double TickSeconds = 1 / SimulatedHarvest.TicksPerSecond;
    private static readonly TimeSpan Poll = TimeSpan.FromMilliseconds(1);
    private readonly SimulatedGame _game;
    private readonly DrivingSession _session;

    /// <summary>Makes ready.</summary>
    /// <param name="game">The game.</param>
    /// <param name="roads">Its roads.</param>
    /// <param name="options">Rate and size of the pictures.</param>
    /// <param name="bridge">To the peer.</param>
    /// <param name="newController">Makes what drives by a peer's indicators.</param>
    /// <param name="isAssisted">Whether the car's own driver drives through junctions and gives way.</param>
    public ServedGame(
        SimulatedGame game, IRoads roads, DrivingOptions options, IDrivingBridge bridge, Func<IController> newController, bool isAssisted)
    {
        _game = game;
        DrivingSession? session = null;
        IDrivenCar car = game.Ports.Car!;
        GamePorts ports = game.Ports with { Roads = roads, Car = isAssisted ? new AssistedCar(car, () => session!.Status, () => game.MustEgoGiveWay) : car };

        // The picture of the simulated game is never behind.
        session = new DrivingSession(options with { SettleTicks = 0 }, ports, bridge, newController);
        _session = session;
    }

    /// <summary>How the drive stands.</summary>
    public DrivingStatus Status => _session.Status;

    /// <summary>Metres that the car has driven; where it was put elsewhere it has not.</summary>
    public double Metres { get; private set; }

    /// <summary>Serves for so many seconds of the game's time, to a fault, or until it is cancelled.</summary>
    public void Run(double seconds, CancellationToken cancellation)
    {
        var wall = Stopwatch.StartNew();
        TimeSpan due = TimeSpan.Zero;
        while (_game.Ports.World.TimeSeconds < seconds && !cancellation.IsCancellationRequested && !_session.Tick().IsOver)
        {
            Tick();
            TimeSpan wait = Poll;
            if (!_game.IsFrozen)
            {
                // A machine that is too slow for the pace does not hurry later.
                TimeSpan now = wall.Elapsed;
                due += TimeSpan.FromSeconds(TickSeconds);
                due = _session.IsStepping || due < now ? now : due;
                wait = due - now;
            }

            if (wait > TimeSpan.Zero)
            {
                cancellation.WaitHandle.WaitOne(wait);
            }
        }
    }

    public void Dispose() => _session.Dispose();

    private void Tick()
    {
        Vector3D before = _game.Ports.World.ReadEgo().Pose.Position;
        _game.Tick(TickSeconds);
        Metres += (_game.Ports.World.ReadEgo().Pose.Position - before).Length;
    }
}
