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
    double FrontAxle
)
{
    /// <summary>Height of the body's lower edge between the wheels.</summary>
    public double Sill { get; init; } = 0.13;

    /// <summary>Radius of the wheels as a fraction of the height.</summary>
    public double WheelRadius { get; init; } = 0.235;

    /// <summary>Distance of the roof's edge from the box's side, as a fraction of the width.</summary>
    public double RoofInset { get; init; } = 0.13;

    /// <summary>How much narrower the body is at its ends, as a fraction of the width.</summary>
    public double Taper { get; init; } = 0.02;

    /// <summary>The side windows, from the cabin's rear end (0) to its front end (1).</summary>
    public (double From, double To)[] Windows { get; init; } = [(0.07, 0.47), (0.52, 0.93)];

    /// <summary>Whether it has a window at the rear.</summary>
    public bool HasRearWindow { get; init; } = true;

    /// <summary>Whether it has an open bed behind the cabin.</summary>
    public bool HasBed { get; init; }

    public static CarProfile Of(VehicleShape shape) =>
        shape switch
        {
            VehicleShape.Hatchback => new(0.56, 0.46, 0.58, 0.02, 0.15, 0.50, 0.74, 0.17, 0.83) { WheelRadius = 0.24 },
            VehicleShape.Coupe => new(0.62, 0.49, 0.62, 0.06, 0.30, 0.44, 0.62, 0.18, 0.82)
            {
                Sill = 0.12,
                WheelRadius = 0.27,
                RoofInset = 0.13,
                Taper = 0.01,
                Windows = [(0.2, 0.92)],
            },
            VehicleShape.Supercar => new(0.62, 0.34, 0.68, 0.10, 0.38, 0.50, 0.80, 0.18, 0.80)
            {
                Sill = 0.09,
                WheelRadius = 0.31,
                RoofInset = 0.19,
                Taper = 0.03,
                Windows = [(0.3, 0.93)],
            },
            VehicleShape.Estate => new(0.60, 0.50, 0.58, 0.012, 0.06, 0.54, 0.70, 0.20, 0.82)
            {
                Windows = [(0.05, 0.3), (0.35, 0.62), (0.66, 0.94)],
            },
            VehicleShape.Suv => new(0.58, 0.56, 0.58, 0.012, 0.035, 0.60, 0.71, 0.19, 0.82)
            {
                Sill = 0.16,
                WheelRadius = 0.215,
                RoofInset = 0.05,
                Taper = 0.01,
                Windows = [(0.05, 0.3), (0.35, 0.63), (0.68, 0.95)],
            },
            VehicleShape.Minivan => new(0.53, 0.43, 0.54, 0.012, 0.05, 0.62, 0.88, 0.19, 0.82)
            {
                WheelRadius = 0.2,
                RoofInset = 0.11,
                Windows = [(0.04, 0.32), (0.36, 0.63), (0.67, 0.93)],
            },
            VehicleShape.Van => new(0.50, 0.47, 0.5, 0.008, 0.015, 0.73, 0.87, 0.19, 0.83)
            {
                Sill = 0.12,
                WheelRadius = 0.175,
                RoofInset = 0.06,
                Taper = 0.012,
                Windows = [(0.74, 0.95)],
                HasRearWindow = false,
            },
            VehicleShape.Pickup => new(0.58, 0.54, 0.57, 0.40, 0.425, 0.57, 0.69, 0.19, 0.82)
            {
                Sill = 0.22,
                WheelRadius = 0.215,
                RoofInset = 0.12,
                Taper = 0.012,
                Windows = [(0.1, 0.92)],
                HasBed = true,
            },
            _ => new(0.60, 0.50, 0.58, 0.13, 0.27, 0.51, 0.70, 0.20, 0.81),
        };
}
