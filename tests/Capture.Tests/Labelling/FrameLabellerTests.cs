using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Tests.Labelling;

/// <summary>
/// A camera at the origin that looks north, 100 x 100 pixels, 90 degrees: focal length 50, so that a point 10 m ahead moves by 5 pixels a metre.
/// The objects are cuboids for the rays too.
/// </summary>
public sealed class FrameLabellerTests
{
    private static readonly HarvestOptions Options = new() { Image = new ImageSize(100, 100) };

    /// <summary>Adaptive maps spend an error of up to 3 % on objects as small as these.</summary>
    private const int MaskPixels = 3;

    private static readonly EntityState Near = Entity(20, 0, 10);

    private static EntityState Entity(int handle, double east, double north) => new(
        handle, ObjectClass.Car, "box", new Pose(new Vector3D(east, north, 0), Axes.Identity), new Vector3D(-1, 0, -1), new Vector3D(1, 2, 1), new Vector3D(0, 3, 0));

    [Fact]
    public void Label_object_ahead_has_its_measures()
    {
        ObjectLabel label = Assert.Single(Label(Options, Near).Objects);

        // The near face is at 10 m: 1 m is 5 pixels to each side of (50, 50).
        AssertBox(new Box2D(45, 45, 55, 55), label.Box2D);
        AssertBox(new Box2D(45, 45, 55, 55), label.Box2DAmodal);
        Assert.Equal((1, ObjectClass.Car, "box"), (label.Id, label.Class, label.Model));
        Assert.Equal((0, 0, 1), (label.TruncatedFraction, label.OccludedFraction, label.VisibleFraction));
        Assert.Equal(OcclusionMethod.Rays, label.OcclusionMethod);
        Assert.Equal(new Vector3D(0, 11, 0), label.Box3D.Centre);
        Assert.Equal(11, label.DistanceMetres, 12);
        Assert.Equal(new Vector3D(0, 3, 0), label.Velocity);
        Assert.Null(label.Box2DVisible);
    }

    [Fact]
    public void Label_object_half_outside_is_cut_and_its_amodal_box_is_not()
    {
        // At 10 m the image reaches 10 m to the side: the near face spans 45 + 50 = 95 to 105, 10 high; 5 x 10 of it lie outside.
        // The far face begins at 50 + 50 * 9 / 12 = 87.5, 100 / 12 high. The silhouette is 100 + 7.5 * (10 + 100 / 12) / 2 = 168.75.
        ObjectLabel label = Assert.Single(Label(Options, Entity(20, 10, 10)).Objects);

        Assert.Equal(100, label.Box2D.XMax);
        Assert.Equal(105, label.Box2DAmodal.XMax, 9);
        Assert.Equal(50 / 168.75, label.TruncatedFraction, 9);
    }

    [Fact]
    public void Label_leaves_out_what_is_behind_beside_too_small_or_of_another_class()
    {
        EntityState[] entities =
        [
            Entity(1, 0, -10),
            Entity(2, 40, 10),
            Entity(3, 0, 60), // 1.7 pixels
            Near,
            Near with { Handle = 21, Class = ObjectClass.Pedestrian, Pose = new Pose(new Vector3D(4, 10, 0), Axes.Identity) },
        ];

        FrameLabelling labelling = Label(Options with { Classes = [ObjectClass.Car] }, entities);

        Assert.Equal(45, Assert.Single(labelling.Objects).Box2D.XMin, 9);
    }

    [Fact]
    public void Label_object_that_is_hidden_altogether_is_left_out_unless_wanted()
    {
        EntityState hidden = Entity(21, 0, 30);

        Assert.Single(Label(Options, Near, hidden).Objects);
        ObjectLabel[] both = [.. Label(Options with { MaxOccludedFraction = 1, MinBoxAreaPixels = 0 }, Near, hidden).Objects];
        Assert.Equal([0, 1], both.Select(label => label.OccludedFraction));
        Assert.Equal(0, both[1].VisibleFraction);
    }

    [Fact]
    public void Label_half_hidden_object_is_half_occluded()
    {
        // Seen past the near one's right edge: both have their middle 20 m away at x = 2, where the near one's edge at 1 m of 10 m ends.
        FrameLabelling labelling = Label(Options with { OcclusionSamples = 400 }, Near, Entity(21, 2, 20));

        // The far near-face spans 52.5 to 57.5, the near one covers up to 55. The right side adds nothing, it is hidden by the near face.
        Assert.InRange(labelling.Objects[1].OccludedFraction!.Value, 0.45, 0.6);
    }

    [Fact]
    public void Label_with_masks_gives_visible_boxes_and_the_numbers_of_kept_objects_only()
    {
        FrameLabelling labelling = Label(Options with { Masks = true, MinBoxAreaPixels = 26 }, Near, Entity(21, 2, 18), Entity(22, -6, 30));

        // Object 22 is 3.3 pixels wide: not kept, and not in the mask.
        Assert.Equal([1, 2], labelling.Objects.Select(label => label.Id));
        Assert.Equal(new Box2D(45, 45, 55, 55), labelling.Objects[0].Box2DVisible);
        Assert.Equal(55, labelling.Objects[1].Box2DVisible!.Value.XMin);
        Assert.Equal([0, 1, 2], labelling.Mask!.Ids.Distinct().Select(id => (int)id).Order());
        Assert.InRange(labelling.PixelMap!.RaysCast, 1, int.MaxValue);
        Assert.Equal(1, labelling.PixelMap.ResolutionPixels);
        Assert.InRange(labelling.PixelMap.InterpolatedPixels, 1, labelling.Mask.Ids.Length - labelling.PixelMap.RaysCast);
        Assert.InRange(labelling.Mask.Ids.Count(id => id == 1), 100 - MaskPixels, 100 + MaskPixels);
        Assert.All(labelling.Objects, label => Assert.Equal(OcclusionMethod.PixelMap, label.OcclusionMethod));
        Assert.InRange(labelling.Objects[0].OccludedFraction!.Value, 0, MaskPixels / 100.0);
        Assert.InRange(labelling.Objects[1].OccludedFraction!.Value, 0.4, 0.6);
    }

    [Fact]
    public void Label_gives_the_same_whatever_the_order_of_handles()
    {
        EntityState left = Entity(30, -4, 10);
        var registry = new ObjectRegistry(1);
        Label(Options, registry, left);
        FrameLabelling labelling = Label(Options, registry, Near, left);

        Assert.Equal([1, 2], labelling.Objects.Select(label => label.Id));
        Assert.True(labelling.Objects[0].Box2D.XMin < labelling.Objects[1].Box2D.XMin);
    }

    private static FrameLabelling Label(HarvestOptions options, params EntityState[] entities) => Label(options, new ObjectRegistry(1), entities);

    private static FrameLabelling Label(HarvestOptions options, ObjectRegistry registry, params EntityState[] entities)
    {
        var snapshot = new SceneSnapshot(
            0, 0,
            new CameraState(new Pose(Vector3D.Zero, Axes.Identity), 90, 0.15, 1),
            new EgoState(7, "blista", new Pose(Vector3D.Zero, Axes.Identity), Vector3D.Zero),
            entities,
            new EnvironmentState("clear", TimeSpan.Zero));
        var labeller = new FrameLabeller(options, new CuboidRays(entities), registry);
        return labeller.Label(snapshot, static () => true).Last()!;
    }

    private static void AssertBox(Box2D expected, Box2D actual)
    {
        Assert.Equal(expected.XMin, actual.XMin, 9);
        Assert.Equal(expected.YMin, actual.YMin, 9);
        Assert.Equal(expected.XMax, actual.XMax, 9);
        Assert.Equal(expected.YMax, actual.YMax, 9);
    }

    private sealed class CuboidRays(EntityState[] entities) : IRayCaster
    {
        public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) => entities
            .Select(entity => (entity.Handle, Span: Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose).Intersect(ray)))
            .Where(hit => hit.Span is { } span && span.Entry <= maxDistance && hit.Handle != ignoredEntity)
            .OrderBy(hit => hit.Span!.Value.Entry)
            .Select(hit => (RayHit?)new RayHit(hit.Span!.Value.Entry, hit.Handle))
            .FirstOrDefault();
    }
}
