using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Tests.Labelling;

/// <summary>
/// A camera at the origin that looks north, 100 x 100 pixels, 90 degrees: focal length 50, so that a point 10 m ahead moves by 5 pixels a
/// metre. The objects are cuboids for the rays too.
/// </summary>
public sealed class FrameLabellerTests
{
    private static readonly HarvestOptions Options = new() { Image = new ImageSize(100, 100) };

    /// <summary>Adaptive maps spend an error of up to 3 % on objects as small as these.</summary>
    private const int MaskPixels = 3;

    private static readonly EntityState Near = Entity(20, 0, 10);

    private static EntityState Entity(int handle, double east, double north, double up = 0) =>
        new(
            handle,
            ObjectClass.Car,
            "box",
            new Pose(new Vector3D(east, north, up), Axes.Identity),
            new Vector3D(-1, 0, -1),
            new Vector3D(1, 2, 1),
            new Vector3D(0, 3, 0)
        );

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
    public void Label_clips_the_box_of_an_object_but_not_its_amodal_box()
    {
        // At 10 m the image reaches 10 m to the side: the near face spans 45 + 50 = 95 to 105, 10 high; 5 x 10 of it lie outside.
        // The far face begins at 50 + 50 * 9 / 12 = 87.5, 100 / 12 high. The silhouette is 100 + 7.5 * (10 + 100 / 12) / 2 = 168.75.
        ObjectLabel label = Assert.Single(Label(Options, Entity(20, 10, 10)).Objects);

        Assert.Equal(100, label.Box2D.XMax);
        Assert.Equal(105, label.Box2DAmodal.XMax, 9);
        Assert.Equal(50 / 168.75, label.TruncatedFraction, 9);
    }

    [Fact]
    public void Label_omits_objects_out_of_view_too_small_or_unselected()
    {
        EntityState[] entities =
        [
            Entity(1, 0, -10),
            Entity(2, 40, 10),
            Entity(3, 0, 60), // 1.7 pixels
            Near,
            Near with
            {
                Handle = 21,
                Class = ObjectClass.Pedestrian,
                Pose = new Pose(new Vector3D(4, 10, 0), Axes.Identity),
            },
        ];

        FrameDraft draft = Label(Options with { Classes = [ObjectClass.Car] }, entities);

        Assert.Equal(45, Assert.Single(draft.Objects).Box2D.XMin, 9);
    }

    [Fact]
    public void Label_omits_a_fully_hidden_object_unless_requested()
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
        FrameDraft draft = Label(Options with { OcclusionSamples = 400 }, Near, Entity(21, 2, 20));

        // The far near-face spans 52.5 to 57.5, the near one covers up to 55: of its 5 or 6 columns of pixels the centres of 2 or 3 are
        // hidden. The right side adds nothing, it is hidden by the near face.
        Assert.InRange(draft.Objects[1].OccludedFraction!.Value, 2 / 5.0, 3 / 5.0);
    }

    [Fact]
    public void Label_with_masks_gives_visible_boxes_and_ids_of_kept_objects()
    {
        FrameDraft draft = Label(Options with { Masks = true, MinBoxAreaPixels = 26 }, Near, Entity(21, 2, 18), Entity(22, -6, 30));

        // Object 22 is 3.3 pixels wide: not kept, and not in the mask.
        Assert.Equal([1, 2], draft.Objects.Select(label => label.Id));
        Assert.Equal(new Box2D(45, 45, 55, 55), draft.Objects[0].Box2DVisible);
        Assert.Equal(55, draft.Objects[1].Box2DVisible!.Value.XMin);
        Assert.Equal([0, 1, 2], draft.Mask!.Ids.Distinct().Select(id => (int)id).Order());
        Assert.InRange(draft.PixelMap!.RaysCast, 1, int.MaxValue);
        Assert.Equal(1, draft.PixelMap.ResolutionPixels);
        Assert.InRange(draft.PixelMap.InterpolatedPixels, 1, draft.Mask.Ids.Length - draft.PixelMap.RaysCast);
        Assert.InRange(draft.Mask.Ids.Count(id => id == 1), 100 - MaskPixels, 100 + MaskPixels);
        Assert.All(draft.Objects, label => Assert.Equal(OcclusionMethod.PixelMap, label.OcclusionMethod));
        Assert.InRange(draft.Objects[0].OccludedFraction!.Value, 0, MaskPixels / 100.0);
        Assert.InRange(draft.Objects[1].OccludedFraction!.Value, 0.4, 0.6);
    }

    [Fact]
    public void Label_gives_the_same_whatever_the_order_of_handles()
    {
        EntityState left = Entity(30, -4, 10);
        var registry = new ObjectRegistry(1);
        Label(Options, registry, left);
        FrameDraft draft = Label(Options, registry, Near, left);

        Assert.Equal([1, 2], draft.Objects.Select(label => label.Id));
        Assert.True(draft.Objects[0].Box2D.XMin < draft.Objects[1].Box2D.XMin);
    }

    [Fact]
    public void Visible_object_out_of_range_is_an_ignore_region()
    {
        FrameDraft draft = LabelWithDistant(Options, [Near], [Entity(21, 10, 20)]);

        // At 20 m, 1 m is 2.5 pixels: 11 m to the right is 50 + 27.5.
        IgnoreRegion region = Assert.Single(draft.IgnoreRegions);
        Assert.Equal((IgnoreReason.BeyondRange, ObjectClass.Car), (region.Reason, region.Class));
        Assert.Equal(77.5, region.Box2D.XMax, 9);
        Assert.Equal(new Vector3D(10, 21, 0).Length, region.DistanceMetres, 9);
        Assert.Equal([1], draft.Objects.Select(label => label.Id));
        Assert.Equal([20], draft.Ids.Keys);
        Assert.Equal((21, Sight.Seen), (Assert.Single(draft.Distant).Entity.Handle, draft.Distant[0].Sight));
    }

    [Fact]
    public void Ignore_regions_are_the_nearest_first()
    {
        FrameDraft draft = LabelWithDistant(Options, [], [Entity(21, 10, 22), Entity(22, -10, 20)]);

        Assert.Equal([22, 21], draft.IgnoreRegions.Select(region => region.Box2D.XMin < 50 ? 22 : 21));
    }

    [Fact]
    public void Hidden_object_out_of_range_is_not_an_ignore_region() =>
        Assert.Empty(LabelWithDistant(Options, [Near], [Entity(21, 0, 30)]).IgnoreRegions);

    [Fact]
    public void Small_or_unselected_object_out_of_range_is_not_ignored() =>
        Assert.Empty(
            LabelWithDistant(
                Options with
                {
                    Classes = [ObjectClass.Car],
                },
                [],
                [Entity(21, 0, 60), Entity(22, 10, 20) with { Class = ObjectClass.Bus }]
            ).IgnoreRegions
        );

    [Fact]
    public void Object_out_of_range_that_no_ray_hits_is_undetermined()
    {
        var labeller = Labeller(Options, new CuboidRays([]), new ObjectRegistry(1));

        IgnoreRegion region = Assert.Single(labeller.LabelAtOnce(Snapshot([]) with { Distant = [Near] }, static () => true).IgnoreRegions);

        Assert.Equal(IgnoreReason.Undetermined, region.Reason);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Object_that_no_ray_hits_is_an_ignore_region_without_label(bool masks)
    {
        FrameDraft draft = Labeller(Options with { Masks = masks }, new CuboidRays([]), new ObjectRegistry(1))
            .LabelAtOnce(Snapshot([Near]), static () => true);

        Assert.Empty(draft.Objects);
        Assert.Equal(
            (IgnoreReason.Undetermined, ObjectClass.Car),
            draft.IgnoreRegions.Select(region => (region.Reason, region.Class)).Single()
        );
        Assert.Equal(Sight.Undetermined, Assert.Single(draft.Occlusions).Sight);
        Assert.True(draft.Mask?.Ids.All(id => id == 0) ?? true);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Object_beyond_the_reach_of_rays_is_ignored_without_rays(bool masks)
    {
        FrameDraft draft = Label(Options with { Masks = masks, RayReachMetres = 8 }, Near);

        Assert.Empty(draft.Objects);
        Assert.Equal(IgnoreReason.Undetermined, Assert.Single(draft.IgnoreRegions).Reason);
        Assert.Equal(0, draft.Rays!.Total);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Object_with_only_empty_space_in_view_has_no_label_or_region(bool masks)
    {
        // The image ends at 10 m to the right at 10 m ahead. Rays hit the entity at its right end only, from 11 m on.
        EntityState wide = Entity(20, 9, 10) with
        {
            ModelMax = new Vector3D(8, 1, 1),
        };
        EntityState rightEnd = Entity(20, 16, 10) with { ModelMax = new Vector3D(1, 1, 1) };
        FrameDraft draft = Labeller(
                Options with
                {
                    Masks = masks,
                    MaxOccludedFraction = 1,
                },
                new CuboidRays([rightEnd]),
                new ObjectRegistry(1)
            )
            .LabelAtOnce(Snapshot([wide]), static () => true);

        Assert.Empty(draft.Objects);
        Assert.Empty(draft.IgnoreRegions);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Rays_of_a_frame_are_counted_by_phase_and_bounded(bool masks)
    {
        // Half of the rays of 192 objects beside and above each other are more than one object may take.
        EntityState[] entities =
        [
            .. Enumerable.Range(0, 192).Select(i => Entity(100 + i, (2.2 * (i % 16)) - 17, north: 30, up: (2.2 * (i / 16)) - 13)),
        ];
        EntityState distant = Entity(50, 6, 20);
        int all = LabelWith(50_000).Total;
        Assert.InRange(LabelWith(all / 2).Total, 1, all / 2);
        Assert.Equal(0, LabelWith(0).Total);

        RayCounts LabelWith(int budget)
        {
            var counted = new CountedRays(new CuboidRays([.. entities, distant]));
            FrameDraft draft = Labeller(Options with { Masks = masks, RayBudget = budget }, counted, new ObjectRegistry(1))
                .LabelAtOnce(Snapshot(entities) with { Distant = [distant] }, static () => true);
            RayCounts rays = draft.Rays!;

            Assert.Equal(counted.Count, rays.Total);
            Assert.Equal(masks ? draft.PixelMap!.RaysCast : 0, rays.Map);
            Assert.Equal(budget == 50_000, draft.Objects.All(label => !label.IsUndetermined) && rays.IgnoreRegions > 0);
            return rays;
        }
    }

    private static FrameDraft LabelWithDistant(HarvestOptions options, EntityState[] entities, EntityState[] distant) =>
        Labeller(options, new CuboidRays([.. entities, .. distant]), new ObjectRegistry(1))
            .LabelAtOnce(Snapshot(entities) with { Distant = distant }, static () => true);

    private static FrameDraft Label(HarvestOptions options, params EntityState[] entities) =>
        Label(options, new ObjectRegistry(1), entities);

    private static FrameDraft Label(HarvestOptions options, ObjectRegistry registry, params EntityState[] entities)
    {
        return Labeller(options, new CuboidRays(entities), registry).LabelAtOnce(Snapshot(entities), static () => true);
    }

    private static FrameLabeller Labeller(HarvestOptions options, IRayCaster rays, ObjectRegistry registry) =>
        new(options, new FrameRays(rays, options.RayBudget), registry);

    private static SceneSnapshot Snapshot(EntityState[] entities) =>
        new(
            0,
            0,
            new CameraState(new Pose(Vector3D.Zero, Axes.Identity), 90, 0.15, 1),
            new EgoState(7, "blista", new Pose(Vector3D.Zero, Axes.Identity), Vector3D.Zero),
            entities,
            new EnvironmentState("clear", TimeSpan.Zero)
        );

    private static void AssertBox(Box2D expected, Box2D actual)
    {
        Assert.Equal(expected.XMin, actual.XMin, 9);
        Assert.Equal(expected.YMin, actual.YMin, 9);
        Assert.Equal(expected.XMax, actual.XMax, 9);
        Assert.Equal(expected.YMax, actual.YMax, 9);
    }

    private sealed class CuboidRays(EntityState[] entities) : IRayCaster
    {
        public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) =>
            entities
                .Select(entity => (entity.Handle, Span: Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose).Intersect(ray)))
                .Where(hit => hit.Span is { } span && span.Entry <= maxDistance && hit.Handle != ignoredEntity)
                .OrderBy(hit => hit.Span!.Value.Entry)
                .Select(hit => (RayHit?)new RayHit(hit.Span!.Value.Entry, hit.Handle))
                .FirstOrDefault();
    }

    private sealed class CountedRays(IRayCaster rays) : IRayCaster
    {
        public int Count { get; private set; }

        public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
        {
            Count++;
            return rays.Cast(ray, maxDistance, ignoredEntity);
        }
    }
}
