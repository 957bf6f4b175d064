namespace Harvester.Simulation.Models;

/// <summary>The body type of a vehicle.</summary>
internal enum VehicleShape
{
    Sedan,
    Hatchback,
    Coupe,
    Supercar,
    Estate,
    Suv,
    Minivan,
    Van,
    Pickup,
    BoxVan,
    BoxTruck,
    DumpTruck,
    Tractor,
    Trailer,
    Tanker,
    LogTrailer,
    Bus,
    Motorcycle,
    Chopper,
    Bicycle,
    Boat,
}
