namespace Harvester.Simulation.Models;

/// <summary>The side view of a car, as fractions of its box: 0 is the rear or the ground, 1 the front or the roof.</summary>
/// <param name="Belt">Height of the windows' lower edge.</param>
/// <param name="Nose">Height of the bonnet's front edge.</param>
/// <param name="Tail">Height of the boot's rear edge.</param>
/// <param name="CabinRear">Where the rear window meets the boot.</param>
/// <param name="RoofRear">Where the rear window meets the roof.</param>
/// <param name="RoofFront">Where the windscreen meets the roof.</param>
/// <param name="CabinFront">Where the windscreen meets the bonnet.</param>
/// <param name="RearAxle">Where the rear wheels are.</param>
/// <param name="FrontAxle">Where the front wheels are.</param>
internal sealed record CarProfile(
    double Belt,
    double Nose,
    double Tail,
    double CabinRear,
    double RoofRear,
    double RoofFront,
    double CabinFront,
    double RearAxle,
    double FrontAxle)
{
    public static CarProfile Of(VehicleShape shape) => shape switch
    {
        VehicleShape.Hatchback => new(0.58, 0.50, 0.56, 0.01, 0.08, 0.52, 0.72, 0.18, 0.82),
        VehicleShape.Coupe => new(0.60, 0.48, 0.56, 0.10, 0.27, 0.48, 0.66, 0.19, 0.81),
        VehicleShape.Supercar => new(0.62, 0.44, 0.62, 0.12, 0.32, 0.53, 0.76, 0.20, 0.80),
        VehicleShape.Estate => new(0.60, 0.50, 0.58, 0.01, 0.06, 0.54, 0.70, 0.20, 0.81),
        VehicleShape.Suv => new(0.60, 0.54, 0.58, 0.01, 0.05, 0.62, 0.75, 0.19, 0.81),
        VehicleShape.Minivan => new(0.56, 0.48, 0.54, 0.01, 0.05, 0.68, 0.86, 0.19, 0.81),
        VehicleShape.Van => new(0.54, 0.46, 0.52, 0.00, 0.015, 0.78, 0.92, 0.19, 0.82),
        _ => new(0.60, 0.50, 0.57, 0.14, 0.25, 0.53, 0.70, 0.20, 0.81),
    };
}
