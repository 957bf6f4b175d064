using Harvester.Driving.Bridge;
using Harvester.Driving.Session;
using Harvester.Runs.Driving;
using Harvester.Simulation.Game;

namespace Harvester.Runs.Serving;

/// <summary>
/// Simulated games that move only by the steps that a client requests, one after the other: each restart builds a new one. The same
/// messages lead to the same frames.
/// </summary>
/// <param name="bridge">The bridge to the client.</param>
/// <param name="newGame">Builds the game of a restart; null for the first one.</param>
/// <param name="newEndpoint">Connects a game to the bridge.</param>
public sealed class LockStepGame(
    IAwaitableBridge bridge,
    Func<RestartMessage?, SimulatedGame> newGame,
    Func<SimulatedGame, GameEndpoint> newEndpoint
)
{
    /// <summary>
    /// Game time of a tick, seconds; a step takes whole ticks. The longest that the world computes at once, as in direct drives.
    /// </summary>
    private const double TickSeconds = 0.05;

    /// <summary>Interval at which cancellation is noticed, and with it a client that has gone.</summary>
    private static readonly TimeSpan Poll = TimeSpan.FromSeconds(0.1);

    /// <summary>Logs connections and problems; null for no log.</summary>
    public ConnectionLog? Connections { get; init; }

    /// <summary>Whether serving ends now.</summary>
    public Func<bool> IsDone { get; init; } = static () => false;

    /// <summary>Distance driven in all games, metres.</summary>
    public double Metres { get; private set; }

    /// <summary>Game time of all games, seconds.</summary>
    public double Seconds { get; private set; }

    /// <summary>Frames sent in all games.</summary>
    public long Frames { get; private set; }

    /// <summary>Serves for a number of seconds of game time, or until a fault or cancellation.</summary>
    /// <returns>Why the game failed; null if it did not.</returns>
    public string? Run(double seconds, CancellationToken cancellation)
    {
        RestartMessage? restart = null;
        string? ending;
        do
        {
            SimulatedGame game = newGame(restart);
            using GameEndpoint endpoint = newEndpoint(game);
            if (restart is not null)
            {
                endpoint.RequestFrame(restart.HasPicture);
            }

            ending = Serve(game, endpoint, seconds - Seconds, cancellation);
            restart = endpoint.Restart;
            Seconds += game.Ports.World.TimeSeconds;
            Metres += endpoint.Metres;
            Frames += endpoint.Status.Frames;
        } while (restart is not null && ending is null && !cancellation.IsCancellationRequested);
        return ending;
    }

    private string? Serve(SimulatedGame game, GameEndpoint endpoint, double seconds, CancellationToken cancellation)
    {
        DrivingStatus status = endpoint.Tick(0);
        while (
            endpoint.Restart is null
            && game.Ports.World.TimeSeconds < seconds
            && !status.IsOver
            && !cancellation.IsCancellationRequested
            && !IsDone()
        )
        {
            bool isStepping = endpoint.IsStepping;
            if (!isStepping)
            {
                if (!endpoint.HasCommands)
                {
                    bridge.AwaitMessage(Poll);
                }

                Connections?.Update(endpoint.Problem);
            }

            status = endpoint.Tick(isStepping ? TickSeconds : 0);
        }

        return status.Ending;
    }
}
