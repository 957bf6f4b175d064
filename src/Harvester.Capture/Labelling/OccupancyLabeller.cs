using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Grids;
using Harvester.Geometry.Work;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>Makes the voxels of a frame.</summary>
/// <param name="origin">
/// The origin of a rig in the frame of the vehicle's model, metres; null without a rig: then that of the voxels is the point of the ground
/// below the model's origin.
/// </param>
/// <param name="solids">The surfaces around the vehicle.</param>
/// <param name="truth">What the picture shows, from which the visible voxels follow.</param>
internal sealed class OccupancyLabeller(Vector3D? origin, ISolids solids, ISurfaceTruth truth) : IChannelLabeller
{
    /// <summary>The classes from those that lie under others to those that count most: small things before large ones.</summary>
    private static readonly SemanticClass[] Order =
    [
        SemanticClass.None,
        SemanticClass.Sky,
        SemanticClass.Water,
        SemanticClass.Terrain,
        SemanticClass.Pavement,
        SemanticClass.Road,
        SemanticClass.LaneMarking,
        SemanticClass.Vegetation,
        SemanticClass.Building,
        SemanticClass.Fence,
        SemanticClass.Pole,
        SemanticClass.Other,
        SemanticClass.TrafficLight,
        SemanticClass.Sign,
        SemanticClass.Trailer,
        SemanticClass.Bus,
        SemanticClass.Truck,
        SemanticClass.Car,
        SemanticClass.Motorcycle,
        SemanticClass.Bicycle,
        SemanticClass.Rider,
        SemanticClass.Pedestrian,
    ];

    private static readonly byte[] Ranks =
    [
        .. Enumerable.Range(0, SemanticClasses.Greatest + 1).Select(kind => (byte)Array.IndexOf(Order, (SemanticClass)kind)),
    ];

    /// <inheritdoc />
    public ChannelTurn Turn => ChannelTurn.Last;

    /// <inheritdoc />
    public string RaysKey => FrameChannels.Occupancy.Key;

    /// <summary>
    /// Gives an id to every object that may have a voxel, seen or not, so that ids do not depend on which frames of a session are labelled.
    /// </summary>
    public static void AssignIds(SceneSnapshot scene, ObjectRegistry registry)
    {
        foreach (EntityState entity in scene.Entities.Where(entity => IsNear(entity, scene.Ego)))
        {
            registry.IdOf(entity);
        }
    }

    /// <inheritdoc />
    public IEnumerable<WorkStep> Label(FrameDraft draft, Func<bool> mayCastRays)
    {
        SceneSnapshot scene = draft.Snapshot;
        Vector3D at = origin ?? new Vector3D(0, 0, -(scene.Ego.HeightAboveGroundMetres ?? 0));
        var grid = new VoxelGrid(new Pose(scene.Ego.Pose.ToWorld(at), scene.Ego.Pose.Axes), VoxelShape.Usual);
        var classes = new Dictionary<int, SemanticClass>();
        foreach (EntityState entity in scene.Entities.Concat(scene.Distant))
        {
            classes[entity.Handle] = SemanticClasses.Of(entity.Class);
        }

        VoxelMap map = solids.Fill(
            grid,
            Ranks,
            handle => classes.TryGetValue(handle, out SemanticClass found) ? found : SemanticClass.Other
        );
        yield return WorkStep.Pause;

        bool[] seen = VoxelSight.Of(draft.Camera, map, truth.Surfaces(draft.Camera.Image).Metres);
        yield return WorkStep.Pause;

        draft.Add(new OccupancyPart(map, at, draft.Ids, seen));
    }

    private static bool IsNear(EntityState entity, EgoState ego)
    {
        double radius = Math.Max(entity.ModelMin.Length, entity.ModelMax.Length);
        return (entity.Pose.Position - ego.Pose.Position).Length <= VoxelShape.Usual.ReachMetres + radius;
    }
}
