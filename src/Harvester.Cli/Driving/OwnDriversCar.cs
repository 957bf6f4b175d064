using System;
using Harvester.Capture.Driving;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Simulation;

namespace Harvester.Cli.Driving;

/// <summary>The simulated car behind a bridge: in junctions and where it has to give way its own driver drives, whatever the peer says.</summary>
internal sealed class OwnDriversCar(SimulatedGame game, IRoads roads) : IDrivenCar
{
    private readonly IDrivenCar _car = game.Ports.Car!;
    private readonly LaneTracker _lanes = new(roads, entity => entity.Handle);
    private readonly Handover _handover = new();

    /// <summary>Whether the peer drives.</summary>
    public bool IsByPeer => _handover.IsToController;

    public bool IsTakenByPlayer => _car.IsTakenByPlayer;

    public void Drive(DrivingControls controls)
    {
        LaneObservation? seen = _lanes.Observe(game.Ports.World.ReadEgo(), [])?.Seen;
        if (_handover.Decide(seen, game.MustEgoGiveWay))
        {
            _car.Drive(controls);
        }
    }

    public void Reset(Vector3D position, double headingDegrees)
    {
        _lanes.Forget();
        _car.Reset(position, headingDegrees);
    }

    public void SetEnvironment(string? weather, TimeSpan? timeOfDay) => _car.SetEnvironment(weather, timeOfDay);
}
