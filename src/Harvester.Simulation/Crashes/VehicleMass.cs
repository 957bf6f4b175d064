using Harvester.Simulation.Models;

namespace Harvester.Simulation.Crashes;

/// <summary>Masses of vehicles and people.</summary>
internal static class VehicleMass
{
    /// <summary>
    /// Mass of a person, also of a driver or rider, kg: the driver of a vehicle's mass in running order (EU Regulation 1230/2012).
    /// </summary>
    public const double Person = 75;

    private static readonly Dictionary<string, VehicleShape> ShapeOf = VehicleRow
        .ReadAll()
        .ToDictionary(row => row.Model, row => row.Shape, StringComparer.Ordinal);

    /// <summary>
    /// Masses of what is neither vehicle nor person, kg: adult animals of the kind, a traffic cone, a barrier of boards, a crate.
    /// </summary>
    private static readonly Dictionary<string, double> Things = new(StringComparer.Ordinal)
    {
        ["a_c_retriever"] = 30,
        ["a_c_deer"] = 80,
        ["a_c_cow"] = 600,
        ["prop_roadcone02a"] = 4,
        ["prop_barrier_work05"] = 30,
        ["prop_box_wood05a"] = 40,
    };

    /// <summary>The mass of a vehicle with its driver or rider, of an animal or of a thing, kg.</summary>
    /// <exception cref="KeyNotFoundException">The mass of the model is unknown.</exception>
    public static double Of(Model model) =>
        ShapeOf.TryGetValue(model.Name, out VehicleShape shape) ? Kerb(shape) + Person : Things[model.Name];

    /// <summary>
    /// The body of a vehicle or thing. Its yaw inertia is that of an even plate, m (l² + w²) / 12; that of real cars is somewhat lower,
    /// because bumpers are light.
    /// </summary>
    /// <param name="model">The model.</param>
    /// <param name="halfLength">Half of its length, metres.</param>
    /// <param name="halfWidth">Half of its width, with an open door, metres.</param>
    public static PlanarBody BodyOf(Model model, double halfLength, double halfWidth)
    {
        double mass = Of(model);
        return new PlanarBody(mass, mass * ((halfLength * halfLength) + (halfWidth * halfWidth)) / 3, halfLength, halfWidth);
    }

    /// <summary>Whether a vehicle falls over when it is struck.</summary>
    public static bool IsTwoWheeler(Model model) =>
        ShapeOf.TryGetValue(model.Name, out VehicleShape shape)
        && shape is VehicleShape.Motorcycle or VehicleShape.Chopper or VehicleShape.Bicycle;

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
