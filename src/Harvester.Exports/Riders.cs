using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports;

/// <summary>Who rides what at a moment.</summary>
/// <param name="vehicles">The vehicle of each rider, by the rider's id.</param>
internal sealed class Riders(IReadOnlyDictionary<int, (int Id, ObjectClass Class)> vehicles)
{
    /// <summary>The ids of the vehicles that are ridden.</summary>
    public IReadOnlySet<int> Ridden { get; } = vehicles.Values.Select(vehicle => vehicle.Id).ToHashSet();

    /// <summary>
    /// The riders of a frame's scene, which has all around the vehicle or, in a session without scenes, those in its image.
    /// </summary>
    /// <exception cref="DatasetFormatException">The scene is damaged.</exception>
    public static Riders At(ExportFrame frame)
    {
        var vehicles = new Dictionary<int, (int Id, ObjectClass Class)>();
        if (frame.Scene is { } scene)
        {
            Dictionary<int, ObjectClass> classes = scene.Snapshot.Entities.ToDictionary(entity => entity.Handle, entity => entity.Class);
            foreach (EntityState rider in scene.Snapshot.Entities.Where(entity => entity.VehicleHandle is not null))
            {
                if (
                    scene.Ids.TryGetValue(rider.Handle, out int id)
                    && scene.Ids.TryGetValue(rider.VehicleHandle!.Value, out int vehicle)
                    && classes.TryGetValue(rider.VehicleHandle.Value, out ObjectClass kind)
                )
                {
                    vehicles[id] = (vehicle, kind);
                }
            }
        }

        Dictionary<int, ObjectClass> listed = frame
            .Label.Objects.GroupBy(label => label.Id)
            .ToDictionary(labels => labels.Key, labels => labels.First().Class);
        foreach (
            (int id, int vehicle) in frame
                .Label.Objects.Where(label => label.Vehicle is { } ridden && listed.ContainsKey(ridden))
                .Select(label => (label.Id, label.Vehicle!.Value))
        )
        {
            vehicles[id] = (vehicle, listed[vehicle]);
        }

        return new Riders(vehicles);
    }

    /// <summary>The vehicle of a rider, by the rider's id; null if it is not known.</summary>
    public (int Id, ObjectClass Class)? VehicleOf(int rider) =>
        vehicles.TryGetValue(rider, out (int, ObjectClass) vehicle) ? vehicle : null;
}
