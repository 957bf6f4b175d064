using Harvester.Simulation.Models;

namespace Harvester.Simulation.Crashes;

/// <summary>Masses of vehicles and people.</summary>
internal static class VehicleMass
{
    /// <summary>Mass of a person, also of a driver or rider, kg: the driver of a vehicle's mass in running order (EU Regulation 1230/2012).</summary>
    public const double Person = 75;

    private static readonly Dictionary<string, VehicleShape> ShapeOf = VehicleRow
        .ReadAll()
        .ToDictionary(row => row.Model, row => row.Shape, StringComparer.Ordinal);

    /// <summary>The mass of a vehicle with its driver or rider, kg.</summary>
    /// <exception cref="KeyNotFoundException">The model is no vehicle.</exception>
    public static double Of(Model model) => Kerb(ShapeOf[model.Name]) + Person;

    /// <summary>
    /// The body of a vehicle. Its yaw inertia is that of an even plate, m (l² + w²) / 12; that of real cars is somewhat lower, because
    /// bumpers are light.
    /// </summary>
    public static PlanarBody BodyOf(Model model)
    {
        double length = model.Max.Y - model.Min.Y;
        double width = model.Max.X - model.Min.X;
        double mass = Of(model);
        return new PlanarBody(mass, mass * ((length * length) + (width * width)) / 12, length / 2, width / 2);
    }

    /// <summary>Whether a vehicle falls over when it is struck.</summary>
    public static bool IsTwoWheeler(Model model) =>
        ShapeOf[model.Name] is VehicleShape.Motorcycle or VehicleShape.Chopper or VehicleShape.Bicycle;

    /// <summary>Kerb mass of a common vehicle of the kind, empty, from its maker's data sheet, kg.</summary>
    private static double Kerb(VehicleShape shape) =>
        shape switch
        {
            // Golf class; large saloon; sports saloon; mid-engined sports car; estate.
            VehicleShape.Hatchback => 1250,
            VehicleShape.Sedan => 1600,
            VehicleShape.Coupe => 1550,
            VehicleShape.Supercar => 1450,
            VehicleShape.Estate => 1650,

            // Full-size American off-roader, minivan, van and pick-up.
            VehicleShape.Suv => 2400,
            VehicleShape.Minivan => 2000,
            VehicleShape.Van => 2300,
            VehicleShape.Pickup => 2300,

            // Parcel van; armoured or fire truck; three-axle dump truck; tractor unit; empty semi-trailers.
            VehicleShape.BoxVan => 4500,
            VehicleShape.BoxTruck => 12_000,
            VehicleShape.DumpTruck => 13_000,
            VehicleShape.Tractor => 8000,
            VehicleShape.Trailer => 6500,
            VehicleShape.Tanker => 7000,
            VehicleShape.LogTrailer => 5500,

            // Rigid city bus; touring and cruiser motorcycles; bicycle; motor boat on its trailer.
            VehicleShape.Bus => 11_000,
            VehicleShape.Motorcycle => 200,
            VehicleShape.Chopper => 300,
            VehicleShape.Bicycle => 13,
            VehicleShape.Boat => 2500,
            _ => throw new ArgumentOutOfRangeException(nameof(shape), shape, "Unknown kind of vehicle."),
        };
}
