using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports;

/// <summary>Two-wheelers together with their riders, as formats want them that label both as one object.</summary>
internal static class RiddenVehicles
{
    /// <summary>
    /// The objects of a frame, with each listed two-wheeler and its listed rider as one object that has the two-wheeler's id and class. A
    /// rider whose two-wheeler is not listed stays as it is.
    /// </summary>
    /// <param name="objects">The objects.</param>
    /// <param name="camera">The camera of the frame.</param>
    /// <exception cref="DatasetFormatException">A cuboid and that of its rider are too far apart for numbers.</exception>
    public static IEnumerable<ObjectLabel> WithRiders(IReadOnlyList<ObjectLabel> objects, CameraLabel camera)
    {
        HashSet<int> listed = [.. objects.Where(label => VehicleClasses.HaveRiders(label.Class)).Select(label => label.Id)];
        ILookup<int, ObjectLabel> riders = objects
            .Where(label => label.Vehicle is { } vehicle && listed.Contains(vehicle))
            .ToLookup(label => label.Vehicle!.Value);
        return objects
            .Where(label => label.Vehicle is not { } vehicle || !listed.Contains(vehicle))
            .Select(label => riders[label.Id].Aggregate(label, (whole, rider) => Joined(whole, rider, camera)));
    }

    /// <summary>
    /// Both as one object. What one hides of the other is no occlusion of both, so the smaller of their occluded fractions counts; the
    /// truncated fraction is their mean by the areas of their amodal boxes. There is no amodal mask of both, only its box.
    /// </summary>
    private static ObjectLabel Joined(ObjectLabel vehicle, ObjectLabel rider, CameraLabel camera)
    {
        Cuboid cuboid = Enclosing(vehicle, rider);
        (double own, double riders) = (vehicle.Box2DAmodal.Area, rider.Box2DAmodal.Area);
        double? occluded =
            vehicle.OccludedFraction is { } first && rider.OccludedFraction is { } second
                ? Math.Min(first, second)
                : vehicle.OccludedFraction ?? rider.OccludedFraction;
        return vehicle with
        {
            Box2D = vehicle.Box2D.Union(rider.Box2D),
            Box2DAmodal = vehicle.Box2DAmodal.Union(rider.Box2DAmodal),
            Box2DVisible = Union(vehicle.Box2DVisible, rider.Box2DVisible),
            Box2DWhole = Union(vehicle.Box2DWhole, rider.Box2DWhole),
            AmodalMask = null,
            TruncatedFraction =
                own + riders > 0
                    ? ((own * vehicle.TruncatedFraction) + (riders * rider.TruncatedFraction)) / (own + riders)
                    : vehicle.TruncatedFraction,
            OccludedFraction = occluded,
            OcclusionMethod = vehicle.OccludedFraction is null ? rider.OcclusionMethod : vehicle.OcclusionMethod,
            TrueOccludedFraction = null,
            Box3D = cuboid,
            DistanceMetres = (cuboid.Centre - camera.Pose.Position).Length,
        };
    }

    private static Box2D? Union(Box2D? a, Box2D? b) => a is { } first && b is { } second ? first.Union(second) : a ?? b;

    /// <summary>The smallest cuboid with the axes of the first that contains both: per axis, from the least to the greatest.</summary>
    private static Cuboid Enclosing(ObjectLabel vehicle, ObjectLabel rider)
    {
        Cuboid first = vehicle.Box3D;
        Vector3D[] corners =
        [
            .. new[] { first, rider.Box3D }.SelectMany(cuboid =>
                Enumerable.Range(0, Cuboid.CornerCount).Select(number => first.Axes.ToLocal(cuboid.Corner(number) - first.Centre))
            ),
        ];
        var least = new Vector3D(corners.Min(corner => corner.X), corners.Min(corner => corner.Y), corners.Min(corner => corner.Z));
        var most = new Vector3D(corners.Max(corner => corner.X), corners.Max(corner => corner.Y), corners.Max(corner => corner.Z));
        try
        {
            return new Cuboid(first.Centre + first.Axes.ToWorld((least + most) * 0.5), (most - least) * 0.5, first.Axes);
        }
        catch (ArgumentOutOfRangeException)
        {
            throw new DatasetFormatException($"box3d of object {vehicle.Id} and of its rider, {rider.Id}, are impossibly far apart.");
        }
    }
}
