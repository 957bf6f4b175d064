using System;
using Harvester.Capture.Ports;

namespace Harvester.Driving.Controllers;

/// <summary>Which controller drives what car by what labels: the one place where controllers are made for cars of the game or the simulation.</summary>
public sealed record ControllerPlan
{
    /// <summary>The game's and the simulation's vehicles are up to 8 m longer than the cars of TORCS: half of that from centre to centre, metres.</summary>
    private const double VehicleAllowance = 4;

    /// <summary>The law.</summary>
    public required ControllerKind Kind { get; init; }

    /// <summary>
    /// How far ahead the angle of the indicators is measured, metres: 10 (default) for those of labels, 0 for those that a client sends, whose
    /// angle is at the car as in TORCS.
    /// </summary>
    public double LookAheadMetres { get; init; } = 10;

    /// <summary>Speed on a free straight road, m/s; null for the law's own.</summary>
    public double? Speed { get; init; }

    /// <summary>Whether an emergency brake stands behind the law.</summary>
    public bool BrakesInEmergency { get; init; }

    /// <summary>The car.</summary>
    public CarTraits Car { get; init; } = new();

    /// <summary>Makes the controller.</summary>
    public IController New()
    {
        IController controller = Kind == ControllerKind.Stanley ? NewStanley() : NewDeepDriving();
        return BrakesInEmergency ? new EmergencyBrake(controller, Car) : controller;
    }

    private StanleyController NewStanley()
    {
        StanleyOptions options = new() { LookAheadMetres = LookAheadMetres, Car = Car };
        return new StanleyController(
            Speed is { } speed ? options with { CruiseSpeed = speed, CautiousSpeed = Math.Min(speed, options.CautiousSpeed) } : options);
    }

    private DeepDrivingController NewDeepDriving() => new(Car, LookAheadMetres, VehicleAllowance, Speed ?? DeepDrivingController.MaxSpeed);
}
