using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Simulation.Game;

namespace Harvester.Runs.Driving;

/// <summary>
/// The simulated car behind a bridge. In junctions and where it must give way, its built-in driver drives instead of the client. Without a
/// client, it brakes everywhere.
/// </summary>
/// <param name="game">The game.</param>
/// <param name="roads">Its roads.</param>
/// <param name="isClientAlive">Whether a client has sent something recently.</param>
public sealed class AssistedCar(SimulatedGame game, IRoads roads, Func<bool> isClientAlive) : IDrivenCar
{
    private readonly IDrivenCar _car = game.Ports.Car!;
    private readonly LaneTracker _lanes = new(roads, entity => entity.Handle);
    private Handover _handover = new();

    /// <summary>Whether the client drives; also true while the car brakes because there is no client.</summary>
    public bool IsByClient { get; private set; }

    /// <inheritdoc/>
    public bool IsTakenByPlayer => _car.IsTakenByPlayer;

    /// <inheritdoc/>
    public void Drive(DrivingControls controls)
    {
        LaneObservation? seen = _lanes.Observe(game.Ports.World.ReadEgo(), [])?.Seen;
        IsByClient = _handover.Decide(seen, game.NeedsOwnDriver) || !isClientAlive();
        if (IsByClient)
        {
            _car.Drive(controls);
        }
    }

    /// <inheritdoc/>
    public void Reset(Vector3D position, double headingDegrees)
    {
        Reset();
        _car.Reset(position, headingDegrees);
    }

    /// <inheritdoc/>
    public void SetEnvironment(string? weather, TimeSpan? timeOfDay) => _car.SetEnvironment(weather, timeOfDay);

    /// <summary>Discards the road and the current driver, as after a teleport of the car.</summary>
    public void Reset()
    {
        _lanes.Reset();
        _handover = new Handover();
    }
}
