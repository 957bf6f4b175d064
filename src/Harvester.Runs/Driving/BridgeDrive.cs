using System.Diagnostics;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Runs.Evaluation.Figures;
using Harvester.Runs.Faults;
using Harvester.Simulation.Game;

namespace Harvester.Runs.Driving;

/// <summary>The game's side of a drive over a bridge, with the simulated game.</summary>
/// <param name="game">The game.</param>
/// <param name="roads">Its roads.</param>
/// <param name="bridge">The bridge to the client.</param>
/// <param name="newController">Creates the controller for indicators that a client sends.</param>
/// <param name="patience">Real time that it waits for a client to drive.</param>
public sealed class BridgeDrive(SimulatedGame game, IRoads roads, IDrivingBridge bridge, Func<IController> newController, TimeSpan patience)
{
    private const double TickSeconds = 0.05;
    private const int TicksPerSample = 2;
    private static readonly TimeSpan PollInterval = TimeSpan.FromMilliseconds(1);

    /// <summary>
    /// The frame of the waiting world is sent again after this time: a client that connected later may be waiting for a frame too.
    /// </summary>
    private static readonly TimeSpan ResendInterval = TimeSpan.FromSeconds(0.5);

    private readonly TruthSampler _sampler = new(game);
    private readonly Stopwatch _silence = new();
    private double _lastClientSeconds;

    /// <summary>Records the drive; null for none.</summary>
    public GameRecording? Recording { get; init; }

    /// <summary>The samples until now.</summary>
    public IReadOnlyList<DriveSample> Samples => _sampler.Samples;

    /// <summary>Drives until the distance or the time limit is reached. The world starts when a client has sent a message.</summary>
    /// <param name="metres">Distance, metres.</param>
    /// <param name="seconds">Time limit, seconds of game time.</param>
    /// <param name="isRealTime">Whether the world runs in real time; otherwise as fast as a client steps it.</param>
    /// <param name="cancellation">Ends the drive.</param>
    /// <exception cref="GameFaultException">The game failed.</exception>
    /// <exception cref="IOException">No client has driven for too long.</exception>
    public void Run(double metres, double seconds, bool isRealTime, CancellationToken cancellation)
    {
        var options = new DrivingOptions { WaitsForAnswers = Recording is not null };
        using GameEndpoint bridged = new(game, roads, options, bridge, newController, isAssisted: true) { Recording = Recording };
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
        var sent = Stopwatch.StartNew();
        while (!cancellation.IsCancellationRequested && !Check(bridged.Tick(0)).IsClientAlive && !bridged.IsStepping)
        {
            cancellation.WaitHandle.WaitOne(PollInterval);
            if (sent.Elapsed > ResendInterval)
            {
                bridged.RequestFrame();
                sent.Restart();
            }
        }
    }

    /// <summary>Ends a drive that has failed, or that no client has advanced for too long.</summary>
    private DrivingStatus Check(DrivingStatus status)
    {
        if (status.Ending is { } ending)
        {
            throw new GameFaultException(ending);
        }

        double now = game.Ports.World.TimeSeconds;
        if (status.IsClientAlive && now != _lastClientSeconds)
        {
            _lastClientSeconds = now;
            _silence.Restart();
        }
        else if (_silence.Elapsed > patience)
        {
            throw new IOException(FormattableString.Invariant($"No client has driven for {patience.TotalSeconds} s."));
        }

        return status;
    }
}
