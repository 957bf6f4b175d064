using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Bridge;
using Harvester.Capture.Driving.Controllers;
using Harvester.Capture.Ports;
using Harvester.Driving.Evaluation;
using Harvester.Simulation;

namespace Harvester.Cli.Driving;

/// <summary>The game's side of a drive over a bridge, with the simulated game: pictures and state out, controls in.</summary>
internal sealed class BridgedDrive(SimulatedGame game, IRoads roads, IDrivingBridge bridge, Func<IController> newController)
{
    private const double TickSeconds = 0.05;
    private const int TicksPerSample = 2;
    private static readonly TimeSpan WaitForPeer = TimeSpan.FromMilliseconds(1);

    private readonly DriveSampler _sampler = new(game);

    /// <summary>Drives so far or so long. The world begins to move when a peer has spoken.</summary>
    /// <param name="metres">Way.</param>
    /// <param name="seconds">The game's time.</param>
    /// <param name="isRealTime">Whether the world's time keeps to the clock; otherwise it goes as fast as a peer steps it.</param>
    /// <param name="cancellation">Ends it.</param>
    public IReadOnlyList<DriveSample> Run(double metres, double seconds, bool isRealTime, CancellationToken cancellation)
    {
        OwnDriversCar car = new(game, roads);
        using DrivingSession session = new(new DrivingOptions { SettleTicks = 0 }, game.Ports with { Roads = roads, Car = car }, bridge, newController);
        while (!session.Tick().IsPeerAlive && !cancellation.IsCancellationRequested)
        {
            Thread.Sleep(WaitForPeer);
        }

        var clock = Stopwatch.StartNew();
        int ticks = 0;
        while (_sampler.Metres < metres && game.Ports.World.TimeSeconds < seconds && !cancellation.IsCancellationRequested)
        {
            if (game.IsFrozen)
            {
                Thread.Sleep(WaitForPeer);
            }
            else if (++ticks % TicksPerSample == 0)
            {
                _sampler.Take(car.IsByPeer);
            }

            game.Tick(TickSeconds);
            session.Tick();
            TimeSpan ahead = TimeSpan.FromSeconds(ticks * TickSeconds) - clock.Elapsed;
            if (isRealTime && ahead > TimeSpan.Zero)
            {
                Thread.Sleep(ahead);
            }
        }

        return _sampler.Samples;
    }
}
