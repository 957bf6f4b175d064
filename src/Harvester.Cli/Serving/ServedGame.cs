using System;
using System.Diagnostics;
using System.Threading;
using Harvester.Capture.Driving;
using Harvester.Cli.Driving;
using Harvester.Cli.Harvesting;
using Harvester.Simulation;

namespace Harvester.Cli.Serving;

/// <summary>A simulated game at the pace of the clock on the wall, for a peer at the other end of a bridge. The steps that a peer asks for are taken as fast as it goes.</summary>
internal sealed class ServedGame(SimulatedGame game, BridgedGame bridged)
{
    private const double TickSeconds = 1 / SimulatedHarvest.TicksPerSecond;
    private static readonly TimeSpan Poll = TimeSpan.FromMilliseconds(1);

    /// <summary>Serves for so many seconds of the game's time, to a fault, or until it is cancelled.</summary>
    public DrivingStatus Run(double seconds, CancellationToken cancellation)
    {
        var wall = Stopwatch.StartNew();
        TimeSpan due = TimeSpan.Zero;
        DrivingStatus status = bridged.Listen();
        while (game.Ports.World.TimeSeconds < seconds && !cancellation.IsCancellationRequested && !status.IsOver)
        {
            TimeSpan wait = Poll;
            if (!game.IsFrozen)
            {
                // A machine that is too slow for the pace does not hurry later.
                TimeSpan now = wall.Elapsed;
                due += TimeSpan.FromSeconds(TickSeconds);
                due = bridged.IsStepping || due < now ? now : due;
                wait = due - now;
            }

            if (wait > TimeSpan.Zero)
            {
                cancellation.WaitHandle.WaitOne(wait);
            }

            status = bridged.Tick(TickSeconds);
        }

        return status;
    }
}
