using Harvester.Datasets.Logs;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>What moves around a frame, by its scene: also what is behind the camera.</summary>
internal static class MotionActors
{
    /// <summary>The key of the car that carries the camera.</summary>
    public const string Ego = "ego";

    /// <summary>The car that carries the camera, then all others. Parked bicycles, which have no class in the formats, are left
    /// out.</summary>
    public static IEnumerable<MotionActor> Of(RecordedScene scene)
    {
        EgoState ego = scene.Snapshot.Ego;
        yield return new MotionActor(
            Ego,
            null,
            TrafficLogKind.Vehicle,
            StateOf(Cuboid.FromModel(ego.ModelMin, ego.ModelMax, ego.Pose), ego.Velocity)
        );
        EntityState[] entities = [.. scene.Snapshot.Entities, .. scene.Snapshot.Distant];
        HashSet<int> present = [.. entities.Select(entity => entity.Handle)];
        ILookup<int, EntityState> riders = entities
            .Where(entity => entity.Class == ObjectClass.Rider && entity.VehicleHandle is not null)
            .ToLookup(entity => entity.VehicleHandle!.Value);
        foreach (EntityState entity in entities)
        {
            if (
                KindOf(entity, riders[entity.Handle].Any()) is { } kind
                && !(IsRider(entity) && present.Contains(entity.VehicleHandle!.Value))
            )
            {
                Cuboid box = riders[entity.Handle].Aggregate(BoxOf(entity), static (whole, rider) => Enclosing(whole, BoxOf(rider)));
                yield return new MotionActor(
                    FormattableString.Invariant($"{entity.Handle} {entity.Model}"),
                    scene.Ids.TryGetValue(entity.Handle, out int id) ? id : null,
                    kind,
                    StateOf(box, entity.Velocity)
                );
            }
        }
    }

    private static bool IsRider(EntityState entity) => entity is { Class: ObjectClass.Rider, VehicleHandle: not null };

    private static TrafficLogKind? KindOf(EntityState entity, bool hasRider) =>
        entity.Class switch
        {
            ObjectClass.Car or ObjectClass.Truck or ObjectClass.Bus => TrafficLogKind.Vehicle,
            ObjectClass.Trailer or ObjectClass.Motorcycle => TrafficLogKind.Vehicle,
            ObjectClass.Bicycle when hasRider || entity.HasRider == true => TrafficLogKind.Cyclist,
            ObjectClass.Pedestrian => TrafficLogKind.Pedestrian,
            ObjectClass.Rider => TrafficLogKind.Cyclist,
            _ => null,
        };

    private static Cuboid BoxOf(EntityState entity) => Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose);

    /// <summary>The smallest box with the axes of the first that contains both.</summary>
    private static Cuboid Enclosing(Cuboid first, Cuboid other)
    {
        Vector3D[] corners =
        [
            -first.HalfExtents,
            first.HalfExtents,
            .. Enumerable.Range(0, Cuboid.CornerCount).Select(number => first.Axes.ToLocal(other.Corner(number) - first.Centre)),
        ];
        var least = new Vector3D(corners.Min(corner => corner.X), corners.Min(corner => corner.Y), corners.Min(corner => corner.Z));
        var most = new Vector3D(corners.Max(corner => corner.X), corners.Max(corner => corner.Y), corners.Max(corner => corner.Z));
        return new Cuboid(first.Centre + first.Axes.ToWorld((least + most) * 0.5), (most - least) * 0.5, first.Axes);
    }

    /// <summary>The upright box: centre and sizes of the cuboid, and the direction of its front on the ground.</summary>
    private static LogState StateOf(Cuboid box, Vector3D velocity) =>
        new(
            box.Centre,
            2 * box.HalfExtents.Y,
            2 * box.HalfExtents.X,
            2 * box.HalfExtents.Z,
            Math.Atan2(box.Axes.Forward.Y, box.Axes.Forward.X),
            new Vector2D(velocity.X, velocity.Y)
        );
}
