using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.Tests.PixelMaps;

public sealed class AdaptivePixelMapperTests
{
    /// <summary>Scenes on which the options were not tuned.</summary>
    private const int OtherSeeds = 5000;

    private static readonly ImageSize Size = new(800, 600);

    private static readonly Camera Camera = new(
        new Pose(Vector3D.Zero, Axes.Identity), new CameraIntrinsics(50, Size, 4.0 / 3, 0.1, Lens.Ideal));

    [Fact]
    public void Run_a_few_town_scenes_agree_with_the_exhaustive_maps()
    {
        var scores = new MapScores();
        foreach (int number in (int[])[3, 22, 31])
        {
            TownScene scene = TownScene.Numbered(number, Size);
            AdaptivePixelMapper mapper = Mapper(scene, scene.Targets(), new PixelMapOptions());
            Assert.True(mapper.Run());
            AdaptivePixelMap map = mapper.Finish();
            Assert.True(map.IsComplete);
            scores.Add(scene.ExhaustiveMap(), map.Map, map.RaysCast);
        }

        AssertAsDemanded(scores, 0.01);
    }

    [Theory]
    [Trait("Category", "Heavy")]
    [InlineData(800, 600, TownScene.FirstSeed, 0.01)]
    [InlineData(800, 600, OtherSeeds, 0.01)]
    [InlineData(1920, 1080, TownScene.FirstSeed, 0.005)]
    public void Run_fifty_town_scenes_agree_with_the_exhaustive_maps(int width, int height, int firstSeed, double greatestRayFraction)
    {
        var scores = new MapScores();
        for (int number = 0; number < 50; number++)
        {
            var scene = new TownScene(firstSeed + number, TownScene.ObjectsOf(number), new ImageSize(width, height));
            AdaptivePixelMapper mapper = Mapper(scene, scene.Targets(), new PixelMapOptions());
            mapper.Run();
            AdaptivePixelMap map = mapper.Finish();
            scores.Add(scene.ExhaustiveMap(), map.Map, map.RaysCast);
        }

        AssertAsDemanded(scores, greatestRayFraction);
    }

    [Fact]
    public void ExhaustiveMap_asked_in_the_boxes_only_is_that_of_the_whole_image()
    {
        TownScene scene = TownScene.Numbered(40, new ImageSize(320, 240));

        InstanceMap whole = ExhaustivePixelMapper.Map(scene.Camera, scene.Camera.Image.Bounds, entity => (ushort)entity, RayHit.World, scene);

        Assert.True(whole.Ids.Distinct().Count() > 10);
        Assert.Equal(whole.Ids, scene.ExhaustiveMap().Ids);
    }

    [Fact]
    public void Run_order_of_the_targets_changes_nothing()
    {
        TownScene scene = TownScene.Numbered(17, Size);
        List<MapTarget> targets = scene.Targets();
        AdaptivePixelMap before = Complete(scene, targets);
        MapTarget[] shuffled = [.. targets];
        new Random(1).Shuffle(shuffled);

        AdaptivePixelMap after = Complete(scene, shuffled);

        Assert.Equal(before.Map.Ids, after.Map.Ids);
        Assert.Equal(before.RaysCast, after.RaysCast);
    }

    [Fact]
    public void Run_numbers_of_the_targets_change_only_the_numbers()
    {
        TownScene scene = TownScene.Numbered(17, Size);
        List<MapTarget> targets = scene.Targets();
        AdaptivePixelMap before = Complete(scene, targets);

        AdaptivePixelMap after = Complete(scene, [.. targets.Select(t => t with { Number = (ushort)(1000 - t.Number) })]);

        Assert.Equal(before.Map.Ids, after.Map.Ids.Select(id => id == 0 ? (ushort)0 : (ushort)(1000 - id)));
    }

    [Fact]
    public void Step_by_step_with_maps_taken_between_gives_the_same_map()
    {
        TownScene scene = TownScene.Numbered(6, Size);
        List<MapTarget> targets = scene.Targets();
        AdaptivePixelMap whole = Complete(scene, targets);
        AdaptivePixelMapper mapper = Mapper(scene, targets, new PixelMapOptions());

        while (mapper.Step())
        {
            if (mapper.RaysCast % 400 == 0)
            {
                mapper.Finish();
            }
        }

        Assert.Equal(whole.Map.Ids, mapper.Finish().Map.Ids);
    }

    [Fact]
    public void Run_more_rays_give_better_maps_and_say_how_good()
    {
        TownScene scene = TownScene.Numbered(20, Size);
        List<MapTarget> targets = scene.Targets();
        InstanceMap exact = scene.ExhaustiveMap();
        double before = -1;
        int resolutionBefore = int.MaxValue;
        foreach (int budget in (int[])[0, 500, 1500, 5000])
        {
            AdaptivePixelMapper mapper = Mapper(scene, targets, new PixelMapOptions { RayBudget = budget });
            Assert.True(mapper.Run());
            AdaptivePixelMap map = mapper.Finish();
            var scores = new MapScores();
            scores.Add(exact, map.Map, map.RaysCast);

            Assert.True(map.RaysCast <= budget);
            Assert.True(scores.Large.Average() > before, $"{budget} rays: {scores.Large.Average()} after {before}");
            Assert.True(map.ResolutionPixels <= resolutionBefore);
            Assert.Equal(budget == 5000, map.IsComplete);
            before = scores.Large.Average();
            resolutionBefore = map.ResolutionPixels;
        }

        Assert.Equal(1, resolutionBefore);
    }

    [Fact]
    public void Run_without_rays_is_the_painters_map()
    {
        TownScene scene = TownScene.Numbered(9, Size);
        List<MapTarget> targets = scene.Targets();
        AdaptivePixelMapper mapper = Mapper(scene, targets, new PixelMapOptions { RayBudget = 0 });

        mapper.Run();
        AdaptivePixelMap map = mapper.Finish();

        Assert.Equal(SilhouettePainter.Paint(scene.Camera, targets).Ids, map.Map.Ids);
        Assert.Equal(0, map.RaysCast);
        Assert.False(map.IsComplete);
    }

    [Fact]
    public void Run_time_up_stops_after_a_ray_and_goes_on_later()
    {
        TownScene scene = TownScene.Numbered(2, Size);
        AdaptivePixelMapper mapper = Mapper(scene, scene.Targets(), new PixelMapOptions());

        Assert.False(mapper.Run(() => true));
        Assert.Equal(1, mapper.RaysCast);
        Assert.False(mapper.Run(() => mapper.RaysCast >= 100));
        Assert.Equal(100, mapper.RaysCast);
        Assert.True(mapper.Run());
        Assert.True(mapper.IsComplete);
    }

    [Theory]
    [InlineData(0.04, 2.0)]
    [InlineData(0.1, 0.9)]
    public void Run_thin_thing_is_found_and_nearly_exact(double half, double halfHeight)
    {
        // At 30 m a pixel is 30 / 643 = 0.047 m: a pole of 1.7 px and a pedestrian's width of 4.3 px.
        var thing = new Cuboid(new(1.3, 30, 0.2), new(half, half, halfHeight), Axes.FromHeading(20));
        var world = new CuboidWorld([(7, thing)]);
        InstanceMap exact = ExhaustivePixelMapper.Map(Camera, Size.Bounds, _ => 1, RayHit.World, world);

        AdaptivePixelMap map = Complete(Camera, world, [Target(7, 1, thing)]);

        var scores = new MapScores();
        scores.Add(exact, map.Map, map.RaysCast);
        Assert.True(scores.Large.Concat(scores.Medium).Single() >= 0.95);
    }

    [Fact]
    public void Run_object_that_rays_do_not_meet_is_drawn_by_its_silhouette()
    {
        // The ghost lies behind the right half of a car, and rays pass through it.
        var car = new Cuboid(new(0, 20, 0), new(2, 1, 1), Axes.Identity);
        var ghost = new Cuboid(new(2, 25, 0), new(2, 1, 1), Axes.Identity);
        MapTarget[] targets = [Target(5, 1, car), Target(6, 2, ghost)];

        AdaptivePixelMap map = Complete(Camera, new CuboidWorld([(5, car)]), targets);

        Assert.Equal(PixelMapMethod.Rays, map.Methods[1]);
        Assert.Equal(PixelMapMethod.Silhouette, map.Methods[2]);
        Assert.Equal(SilhouettePainter.Paint(Camera, targets).MapOf(2).Count, map.Map.MapOf(2).Count, 20.0);
    }

    [Fact]
    public void Run_hidden_object_is_not_taken_for_one_that_rays_do_not_meet()
    {
        var wall = new Cuboid(new(0, 10, 0), new(9, 0.2, 9), Axes.Identity);
        var car = new Cuboid(new(0, 20, 0), new(2, 1, 1), Axes.Identity);

        AdaptivePixelMap map = Complete(Camera, new CuboidWorld([(RayHit.World, wall), (6, car)]), [Target(6, 2, car)]);

        Assert.Equal(PixelMapMethod.Rays, map.Methods[2]);
        Assert.Null(map.Map.BoundsOf(2));
    }

    [Fact]
    public void Run_object_of_which_only_the_gaps_are_in_the_image_is_not_drawn_by_its_silhouette()
    {
        // At 20 m the image ends at x = 20 tan(25 deg) 4/3 = 12.4 m: the post stands outside, the empty half of its cuboid inside.
        var post = new Cuboid(new(14.5, 20, 0), new(0.5, 0.5, 1), Axes.Identity);
        var withGap = new Cuboid(new(13, 20, 0), new(2, 0.5, 1), Axes.Identity);
        var wall = new Cuboid(new(0, 30, 0), new(60, 1, 9), Axes.Identity);

        AdaptivePixelMap map = Complete(Camera, new CuboidWorld([(5, post), (6, wall)]), [Target(5, 1, withGap), Target(6, 2, wall)]);

        Assert.Equal(PixelMapMethod.Rays, map.Methods[1]);
        Assert.Null(map.Map.BoundsOf(1));
    }

    [Fact]
    public void Run_thin_arms_of_an_object_that_fills_little_of_its_cuboid_are_found()
    {
        // A traffic light at 40 m, where a pixel is 40 / 643 = 0.062 m: a pole of 2 px and an arm of 64 px by 2 px in a box of 64 by 97 px.
        var pole = new Cuboid(new(2, 40, 0), new(0.06, 0.06, 3), Axes.Identity);
        var arm = new Cuboid(new(0.06, 40, 2.7), new(2, 0.06, 0.06), Axes.Identity);
        var bounds = new Cuboid(new(0.06, 40, 0), new(2, 0.06, 3), Axes.Identity);
        var world = new CuboidWorld([(7, pole), (7, arm)]);
        InstanceMap exact = ExhaustivePixelMapper.Map(Camera, Size.Bounds, _ => 1, RayHit.World, world);

        AdaptivePixelMap map = Complete(Camera, world, [Target(7, 1, bounds)]);

        var scores = new MapScores();
        scores.Add(exact, map.Map, map.RaysCast);
        Assert.True(scores.Large.Concat(scores.Medium).Single() >= 0.95);
    }

    [Fact]
    public void Run_beyond_the_reach_of_rays_costs_none_and_says_so()
    {
        var car = new Cuboid(new(0, 200, 0), new(2, 1, 1), Axes.Identity);
        var world = new CuboidWorld([]);
        var mapper = new AdaptivePixelMapper(
            Camera, [Target(6, 2, car)], RayHit.World, world, new PixelMapOptions { RayReachMetres = 100 });

        mapper.Run();
        AdaptivePixelMap map = mapper.Finish();

        Assert.Equal(0, world.RaysCast);
        Assert.Equal(PixelMapMethod.Silhouette, map.Methods[2]);
        Assert.NotNull(map.Map.BoundsOf(2));
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(1, 40)]
    [InlineData(33, 2)]
    [InlineData(65, 65)]
    public void Run_image_of_any_size_is_mapped(int width, int height)
    {
        var camera = new Camera(Camera.Pose, new CameraIntrinsics(50, new ImageSize(width, height), 4.0 / 3, 0.1, Lens.Ideal));
        var wall = new Cuboid(new(0, 10, 0), new(90, 0.2, 90), Axes.Identity);
        var world = new CuboidWorld([(3, wall)]);

        AdaptivePixelMap map = Complete(camera, world, [new MapTarget(3, 9, wall, CuboidProjector.Project(camera, wall))]);

        Assert.Equal(width * height, map.Map.MapOf(9).Count);
    }

    [Fact]
    public void AdaptivePixelMapper_invalid_input_is_refused()
    {
        var car = new Cuboid(new(0, 20, 0), new(2, 1, 1), Axes.Identity);
        var world = new CuboidWorld([]);
        Assert.Throws<ArgumentException>(() => Complete(Camera, world, [Target(5, 1, car), Target(6, 1, car)]));
        Assert.Throws<ArgumentException>(() => Complete(Camera, world, [Target(5, 1, car), Target(5, 2, car)]));
        Assert.Throws<ArgumentException>(() => Complete(Camera, world, [Target(5, 0, car)]));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => new AdaptivePixelMapper(Camera, [], 0, world, new PixelMapOptions { RayBudget = -1 }));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => new AdaptivePixelMapper(Camera, [], 0, world, new PixelMapOptions { CellErrorFraction = double.NaN }));
        Assert.Throws<ArgumentNullException>(() => new AdaptivePixelMapper(Camera, [], 0, null!, new PixelMapOptions()));
    }

    private static void AssertAsDemanded(MapScores scores, double greatestRayFraction)
    {
        Assert.InRange(scores.Large.Average(), 0.99, 1);
        Assert.InRange(scores.Large.Min(), 0.95, 1);
        Assert.InRange(scores.Medium.Average(), 0.97, 1);
        Assert.InRange(scores.SmallFound.Average(found => found ? 1.0 : 0), 0.99, 1);
        Assert.InRange(scores.MeanRayFraction, 0, greatestRayFraction);
        Assert.InRange(scores.GreatestShareOfAllowedRays, 0, 1);
    }

    private static AdaptivePixelMapper Mapper(TownScene scene, IReadOnlyList<MapTarget> targets, PixelMapOptions options) =>
        new(scene.Camera, targets, RayHit.World, scene, options);

    private static AdaptivePixelMap Complete(TownScene scene, IReadOnlyList<MapTarget> targets) =>
        Complete(scene.Camera, scene, targets);

    private static AdaptivePixelMap Complete(Camera camera, IRayCaster rays, IReadOnlyList<MapTarget> targets)
    {
        var mapper = new AdaptivePixelMapper(camera, targets, RayHit.World, rays, new PixelMapOptions());
        mapper.Run();
        return mapper.Finish();
    }

    private static MapTarget Target(int entity, ushort number, Cuboid cuboid) =>
        new(entity, number, cuboid, CuboidProjector.Project(Camera, cuboid));
}
