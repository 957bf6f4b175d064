using System.Collections.Generic;
using System.Linq;
using Harvester.Datasets.Files;
using Harvester.Sessions.Files;
using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Exports;

/// <summary>Who rides what at a moment.</summary>
internal sealed class Riders
{
    private readonly Dictionary<int, (int Id, ObjectClass Class)> _vehicles = [];

    /// <summary>
    /// The riders of a frame's scene, which has all around the vehicle or, in a session without scenes, those in its image.
    /// </summary>
    /// <exception cref="DatasetFormatException">The scene is damaged.</exception>
    public static Riders At(ExportFrame frame)
    {
        var riders = new Riders();
        if (FrameScene.Read(frame) is { } scene)
        {
            Dictionary<int, ObjectClass> classes = scene.Snapshot.Entities.ToDictionary(entity => entity.Handle, entity => entity.Class);
            foreach (EntityState rider in scene.Snapshot.Entities.Where(entity => entity.VehicleHandle is not null))
            {
                if (scene.Ids.TryGetValue(rider.Handle, out int id) && scene.Ids.TryGetValue(rider.VehicleHandle!.Value, out int vehicle)
                    && classes.TryGetValue(rider.VehicleHandle.Value, out ObjectClass kind))
                {
                    riders._vehicles[id] = (vehicle, kind);
                }
            }
        }

        Dictionary<int, ObjectClass> listed = frame.Label.Objects.GroupBy(label => label.Id)
            .ToDictionary(labels => labels.Key, labels => labels.First().Class);
        foreach ((int id, int vehicle) in frame.Label.Objects.Where(label => label.Vehicle is { } ridden && listed.ContainsKey(ridden))
            .Select(label => (label.Id, label.Vehicle!.Value)))
        {
            riders._vehicles[id] = (vehicle, listed[vehicle]);
        }

        return riders;
    }

    /// <summary>The vehicle of a rider, by the rider's id; null if it is not known.</summary>
    public (int Id, ObjectClass Class)? VehicleOf(int rider) => _vehicles.TryGetValue(rider, out (int, ObjectClass) vehicle) ? vehicle : null;

    /// <summary>The ids of the vehicles that are ridden.</summary>
    public IReadOnlySet<int> Ridden => _vehicles.Values.Select(vehicle => vehicle.Id).ToHashSet();
}
