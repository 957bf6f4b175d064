using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Threading;
using Harvester.Capture.Ports;
using Harvester.Cli.Terminals;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Evaluation.Figures;
using Harvester.Simulation.Game;

namespace Harvester.Cli.Driving;

/// <summary>The game's side of a drive over a bridge, with the simulated game: pictures and state out, controls in.</summary>
/// <param name="game">The game.</param>
/// <param name="roads">Its roads.</param>
/// <param name="bridge">To the client.</param>
/// <param name="newController">Makes what drives by a client's indicators.</param>
/// <param name="patience">For so long, on the clock, it waits for a client to drive.</param>
internal sealed class RemoteDrive(
    SimulatedGame game, IRoads roads, IDrivingBridge bridge, Func<IController> newController, TimeSpan patience)
{
    private const double TickSeconds = 0.05;
    private const int TicksPerSample = 2;
    private static readonly TimeSpan Look = TimeSpan.FromMilliseconds(1);

    /// <summary>
    /// A client may have come after the frame of the world that waits for it, and may wait for a frame itself: it is shown so often.
    /// </summary>
    private static readonly TimeSpan ShowAgainAfter = TimeSpan.FromSeconds(0.5);

    private readonly DriveSampler _sampler = new(game);
    private readonly Stopwatch _silence = new();
    private double _heardSeconds;

    /// <summary>What was driven until now.</summary>
    public IReadOnlyList<DriveSample> Samples => _sampler.Samples;

    /// <summary>Drives so far or so long. The world begins to move when a client has spoken.</summary>
    /// <param name="metres">Way.</param>
    /// <param name="seconds">The game's time.</param>
    /// <param name="isRealTime">Whether the world's time keeps to the clock; otherwise it goes as fast as a client steps it.</param>
    /// <param name="cancellation">Ends it.</param>
    /// <exception cref="GameFaultException">The game failed.</exception>
    /// <exception cref="IOException">No client has driven for too long.</exception>
    public void Run(double metres, double seconds, bool isRealTime, CancellationToken cancellation)
    {
        using GameEndpoint bridged = new(game, roads, new DrivingOptions(), bridge, newController, isAssisted: true);
        _silence.Restart();
        WaitForClient(bridged, cancellation);
        WallPace pace = new(TickSeconds, TimeProvider.System);
        int ticks = 0;
        while (_sampler.Metres < metres && game.Ports.World.TimeSeconds < seconds && !cancellation.IsCancellationRequested)
        {
            pace.Wait(game.IsFrozen, isHurried: !isRealTime || bridged.IsStepping, cancellation);
            if (!game.IsFrozen && ++ticks % TicksPerSample == 0)
            {
                _sampler.Take(bridged.IsByClient);
            }

            Check(bridged.Tick(TickSeconds));
        }
    }

    private void WaitForClient(GameEndpoint bridged, CancellationToken cancellation)
    {
        var shown = Stopwatch.StartNew();
        while (!cancellation.IsCancellationRequested && !Check(bridged.Listen()).IsClientAlive && !bridged.IsStepping)
        {
            cancellation.WaitHandle.WaitOne(Look);
            if (shown.Elapsed > ShowAgainAfter)
            {
                bridged.ShowAgain();
                shown.Restart();
            }
        }
    }

    /// <summary>A drive that is over, or that no client takes further, does not go on for ever.</summary>
    private DrivingStatus Check(DrivingStatus status)
    {
        if (status.Ending is { } ending)
        {
            throw new GameFaultException(ending);
        }

        double now = game.Ports.World.TimeSeconds;
        if (status.IsClientAlive && now != _heardSeconds)
        {
            _heardSeconds = now;
            _silence.Restart();
        }
        else if (_silence.Elapsed > patience)
        {
            throw new IOException(FormattableString.Invariant($"No client has driven for {patience.TotalSeconds} s."));
        }

        return status;
    }
}
