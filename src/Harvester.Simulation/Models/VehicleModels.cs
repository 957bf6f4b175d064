using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>The vehicles of the embedded list.</summary>
internal static class VehicleModels
{
    public static IEnumerable<Model> All() => VehicleRow.ReadAll().Select(Build);

    private static Model Build(VehicleRow row) =>
        new(row.Model, row.Class, row.Min, row.Max, ColoursOf(row).Select(colour => MeshOf(row, colour)).ToArray())
        {
            Riders = VehicleClasses.HaveRiders(row.Class) ? RiderModels.Of(row) : [],
            Lamps = new VehicleLampMeshes(VehicleLampLayout.Of(row)),
        };

    private static Mesh MeshOf(VehicleRow row, Rgb colour) =>
        row.Shape switch
        {
            VehicleShape.Motorcycle or VehicleShape.Chopper or VehicleShape.Bicycle => CycleModels.Build(row, colour),
            VehicleShape.BoxVan or VehicleShape.BoxTruck or VehicleShape.DumpTruck or VehicleShape.Tractor => LorryModels.Build(
                row,
                colour
            ),
            VehicleShape.Trailer or VehicleShape.Tanker or VehicleShape.LogTrailer => TrailerModels.Build(row, colour),
            VehicleShape.Bus => BusModels.Build(row, colour),
            VehicleShape.Boat => BoatModels.Build(row, colour),
            _ => CarModels.Build(row, colour),
        };

    private static Rgb[] ColoursOf(VehicleRow row) =>
        row switch
        {
            { Paint: { } paint } => [paint],
            { Shape: VehicleShape.Motorcycle or VehicleShape.Chopper or VehicleShape.Bicycle } => VehiclePaint.Cycles,
            { Class: ObjectClass.Car } => VehiclePaint.Cars,
            _ => VehiclePaint.Lorries,
        };
}
