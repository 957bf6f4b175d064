using Harvester.Driving.Session;
using Harvester.Runs.Driving;
using Harvester.Runs.Harvesting;
using Harvester.Simulation.Game;

namespace Harvester.Runs.Serving;

/// <summary>
/// A simulated game that runs in real time for a client of a bridge. Single steps that a client requests are taken as fast as possible.
/// </summary>
public sealed class ServedGame(SimulatedGame game, GameEndpoint bridged)
{
    private const double TickSeconds = 1 / SimulatedHarvest.TicksPerSecond;

    /// <summary>Logs connections, once per tick; null for no log.</summary>
    public ConnectionLog? Connections { get; init; }

    /// <summary>Whether serving ends now.</summary>
    public Func<bool> IsDone { get; init; } = static () => false;

    /// <summary>Serves for a number of seconds of game time, or until a fault or cancellation.</summary>
    public DrivingStatus Run(double seconds, CancellationToken cancellation)
    {
        WallPace pace = new(TickSeconds, TimeProvider.System);
        DrivingStatus status = bridged.Tick(0);
        while (game.Ports.World.TimeSeconds < seconds && !cancellation.IsCancellationRequested && !status.IsOver && !IsDone())
        {
            pace.Wait(game.IsFrozen, isHurried: bridged.IsStepping, cancellation);
            status = bridged.Tick(TickSeconds);
            Connections?.Update(bridged.Problem);
        }

        return status;
    }
}
