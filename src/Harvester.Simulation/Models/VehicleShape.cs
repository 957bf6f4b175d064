namespace Harvester.Simulation.Models;

/// <summary>How a vehicle is built.</summary>
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
