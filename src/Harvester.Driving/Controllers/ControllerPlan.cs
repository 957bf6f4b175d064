using Harvester.Capture.Ports;

namespace Harvester.Driving.Controllers;

/// <summary>Settings of a controller. Creates the controllers for cars of the game or the simulation.</summary>
public sealed record ControllerPlan
{
    /// <summary>
    /// Allowance for vehicles up to 8 m longer than the cars of TORCS, metres: half of that, as distances are from centre to centre.
    /// </summary>
    private const double VehicleAllowance = 4;

    /// <summary>The control law to use.</summary>
    public required ControllerKind Kind { get; init; }

    /// <summary>
    /// Distance ahead of the car at which the angle of the indicators is measured, metres, 0 or more: 10 (default) for indicators of
    /// labels, 0 for those sent by a client, whose angle is at the car as in TORCS.
    /// </summary>
    public double LookAheadMetres { get; init; } = 10;

    /// <summary>Speed on a free straight road, m/s; null for the default of the control law.</summary>
    public double? Speed { get; init; }

    /// <summary>Whether an emergency brake may override the control law.</summary>
    public bool BrakesInEmergency { get; init; }

    /// <summary>Steering lock, wheelbase and other traits of the driven car.</summary>
    public CarTraits Car { get; init; } = new();

    /// <summary>Creates a controller with these settings and no memory of the road.</summary>
    public IController New()
    {
        IController controller = Kind == ControllerKind.Stanley ? NewStanley() : NewDeepDriving();
        return BrakesInEmergency ? new EmergencyBrake(controller, Car) : controller;
    }

    private StanleyController NewStanley()
    {
        StanleyOptions options = new() { LookAheadMetres = LookAheadMetres, Car = Car };
        return new StanleyController(
            Speed is { } speed ? options with { CruiseSpeed = speed, CautiousSpeed = Math.Min(speed, options.CautiousSpeed) } : options
        );
    }

    private DeepDrivingController NewDeepDriving() => new(Car, LookAheadMetres, VehicleAllowance, Speed ?? DeepDrivingController.MaxSpeed);
}
