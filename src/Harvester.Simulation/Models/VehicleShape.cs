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
    BoxVan,
    BoxTruck,
    DumpTruck,
    Tractor,
    Trailer,
    Bus,
    Motorcycle,
    Bicycle,
}
