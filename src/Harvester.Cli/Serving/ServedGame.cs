using System;
using System.Threading;
using Harvester.Cli.Driving;
using Harvester.Cli.Harvesting;
using Harvester.Driving.Session;
using Harvester.Simulation.Game;

namespace Harvester.Cli.Serving;

/// <summary>
/// A simulated game at the pace of the clock on the wall, for a client at the other end of a bridge. The steps that a client asks for are
/// taken as fast as it goes.
/// </summary>
internal sealed class ServedGame(SimulatedGame game, GameEndpoint bridged)
{
    private const double TickSeconds = 1 / SimulatedHarvest.TicksPerSecond;

    /// <summary>Looks at the bridge in each tick; null for nobody.</summary>
    public VisitLog? Visits { get; init; }

    /// <summary>Serves for so many seconds of the game's time, to a fault, or until it is cancelled.</summary>
    public DrivingStatus Run(double seconds, CancellationToken cancellation)
    {
        WallPace pace = new(TickSeconds, TimeProvider.System);
        DrivingStatus status = bridged.Listen();
        while (game.Ports.World.TimeSeconds < seconds && !cancellation.IsCancellationRequested && !status.IsOver)
        {
            pace.Wait(game.IsFrozen, isHurried: bridged.IsStepping, cancellation);
            status = bridged.Tick(TickSeconds);
            Visits?.Look(bridged.Problem);
        }

        return status;
    }
}
