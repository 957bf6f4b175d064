namespace Harvester.Sessions.Scenes;

/// <summary>
/// The classes of vehicles, and the class of a model: by its name if the game's class is ambiguous, otherwise by that class.
/// </summary>
public static class VehicleClasses
{
    private static readonly Dictionary<int, ObjectClass> ByModel = new[]
    {
        (ObjectClass.Bus, "airbus bus coach pbus pbus2 rentalbus tourbus"),
        (ObjectClass.Truck, "firetruk riot trash trash2 barracks barracks2 barracks3 utillitruck utillitruck2 ripley"),
        (ObjectClass.Motorcycle, "policeb"),
        (
            ObjectClass.Trailer,
            "armytanker armytrailer armytrailer2 baletrailer boattrailer docktrailer freighttrailer graintrailer proptrailer raketrailer"
                + " tanker tanker2 tr2 tr3 tr4 trailerlarge trailerlogs trailers trailers2 trailers3 trailers4 trailersmall"
                + " trailersmall2 trflat tvtrailer"
        ),
    }
        .SelectMany(kind => kind.Item2.Split(' ').Select(model => (Hash: ModelHash.Of(model), Class: kind.Item1)))
        .ToDictionary(model => model.Hash, model => model.Class);

    /// <summary>The class of a vehicle.</summary>
    /// <param name="model">Hash of its model.</param>
    /// <param name="gameClass">Number of the game's vehicle class.</param>
    public static ObjectClass Of(int model, int gameClass)
    {
        const int motorcycles = 8,
            industrial = 10,
            cycles = 13,
            boats = 14,
            helicopters = 15,
            planes = 16,
            commercial = 20,
            trains = 21;
        if (ByModel.TryGetValue(model, out ObjectClass known))
        {
            return known;
        }

        return gameClass switch
        {
            motorcycles => ObjectClass.Motorcycle,
            cycles => ObjectClass.Bicycle,
            industrial or commercial => ObjectClass.Truck,
            boats or helicopters or planes or trains => ObjectClass.Other,
            _ => ObjectClass.Car,
        };
    }

    /// <summary>Whether objects of a class are vehicles, which count as traffic in lanes.</summary>
    public static bool AreVehicles(ObjectClass kind) =>
        kind
            is ObjectClass.Car
                or ObjectClass.Truck
                or ObjectClass.Bus
                or ObjectClass.Motorcycle
                or ObjectClass.Bicycle
                or ObjectClass.Trailer;

    /// <summary>Whether objects of a class have riders, who sit on them and not in them.</summary>
    public static bool HaveRiders(ObjectClass kind) => kind is ObjectClass.Motorcycle or ObjectClass.Bicycle;

    /// <summary>Whether objects of a class are people: on foot, or on a two-wheeler.</summary>
    public static bool ArePeople(ObjectClass kind) => kind is ObjectClass.Pedestrian or ObjectClass.Rider;
}
