using System.Collections.Generic;
using System.Linq;

namespace Harvester.Sessions.Scenes;

/// <summary>What kind of thing a vehicle is: by its model where the game's class mixes kinds, by that class otherwise.</summary>
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
            + " tanker tanker2 tr2 tr3 tr4 trailerlarge trailerlogs trailers trailers2 trailers3 trailers4 trailersmall trailersmall2 trflat tvtrailer"),
    }
        .SelectMany(kind => kind.Item2.Split(' ').Select(model => (Hash: ModelHash.Of(model), Class: kind.Item1)))
        .ToDictionary(model => model.Hash, model => model.Class);

    /// <summary>The kind of a vehicle.</summary>
    /// <param name="model">Hash of its model.</param>
    /// <param name="gameClass">Number of the game's class of vehicles.</param>
    public static ObjectClass Of(int model, int gameClass)
    {
        const int motorcycles = 8, industrial = 10, cycles = 13, boats = 14, helicopters = 15, planes = 16, commercial = 20, trains = 21;
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
}
