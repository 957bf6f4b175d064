using Harvester.Capture.Ports;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Grids;
using Harvester.Geometry.Work;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>Makes the bird's-eye map of a frame: the ground, over it vehicles, over them people.</summary>
/// <param name="shape">The size of the map.</param>
/// <param name="ground">The ground.</param>
/// <param name="truth">What the picture truly shows, from which the visible cells follow; null if that is unknown.</param>
internal sealed class BirdsEyeLabeller(GridShape shape, IGround ground, ISurfaceTruth? truth) : IChannelLabeller
{
    /// <inheritdoc />
    public ChannelTurn Turn => ChannelTurn.Last;

    /// <inheritdoc />
    public string RaysKey => FrameChannels.BirdsEye.Key;

    /// <inheritdoc />
    public IEnumerable<WorkStep> Label(FrameDraft draft, Func<bool> mayCastRays)
    {
        SceneSnapshot scene = draft.Snapshot;
        var grid = new EgoGrid(scene.Ego.Pose, scene.Ego.HeightAboveGroundMetres ?? 0, shape);
        var map = new GroundMap(grid, ground.Near(scene.Ego.Pose.Position, shape.ReachMetres) ?? []);
        yield return WorkStep.Pause;

        int[] owners = new int[map.Kinds.Count];
        BirdsEyeClass[] classes = [.. map.Kinds.Select(static kind => (BirdsEyeClass)kind)];
        foreach (
            (EntityState body, BirdsEyeClass kind) in scene
                .Entities.Concat(scene.Distant)
                .Select(static entity => (entity, ClassOf(entity.Class)))
                .Where(static each => each.Item2 != BirdsEyeClass.Other)
                .OrderBy(static each => each.Item2)
        )
        {
            foreach (int cell in map.CellsUnder(Cuboid.FromModel(body.ModelMin, body.ModelMax, body.Pose)))
            {
                (classes[cell], owners[cell]) = (kind, body.Handle);
            }
        }

        yield return WorkStep.Pause;

        draft.Add(
            new BirdsEyePart(shape, classes, truth is null ? null : VisibleCells.Of(draft.Camera, map, owners, truth), ground.Source)
        );
    }

    private static BirdsEyeClass ClassOf(ObjectClass kind) =>
        kind switch
        {
            ObjectClass.Car
            or ObjectClass.Truck
            or ObjectClass.Bus
            or ObjectClass.Motorcycle
            or ObjectClass.Bicycle
            or ObjectClass.Trailer => BirdsEyeClass.Vehicle,
            ObjectClass.Pedestrian or ObjectClass.Rider => BirdsEyeClass.Person,
            _ => BirdsEyeClass.Other,
        };
}
