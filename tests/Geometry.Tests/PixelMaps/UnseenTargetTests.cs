using Harvester.Geometry.Boxes;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.Tests.PixelMaps;

/// <summary>Objects that rays do not hit, or that are hidden.</summary>
public sealed class UnseenTargetTests
{
    [Fact]
    public void Run_marks_an_object_that_no_ray_hits_as_undetermined()
    {
        // The ghost lies behind the right half of a car, and rays pass through it.
        var car = new Cuboid(new(0, 20, 0), new(2, 1, 1), Axes.Identity);
        var ghost = new Cuboid(new(2, 25, 0), new(2, 1, 1), Axes.Identity);
        MapTarget[] targets = [SmallWorld.Target(5, 1, car), SmallWorld.Target(6, 2, ghost)];

        AdaptivePixelMap map = MapRun.Complete(SmallWorld.Camera, new CuboidWorld([(5, car)]), targets);

        Assert.Equal((Sight.Seen, Sight.Undetermined), (map.Sights[1], map.Sights[2]));
        Assert.Null(map.Map.BoundsOf(2));
    }

    [Fact]
    public void Run_distinguishes_hidden_objects_from_those_no_ray_hits()
    {
        var wall = new Cuboid(new(0, 10, 0), new(9, 0.2, 9), Axes.Identity);
        var car = new Cuboid(new(0, 20, 0), new(2, 1, 1), Axes.Identity);

        AdaptivePixelMap map = MapRun.Complete(
            SmallWorld.Camera,
            new CuboidWorld([(RayHit.World, wall), (6, car)]),
            [SmallWorld.Target(6, 2, car)]
        );

        Assert.Equal(Sight.Unseen, map.Sights[2]);
        Assert.Null(map.Map.BoundsOf(2));
    }

    [Fact]
    public void Run_object_with_only_its_gaps_in_the_image_is_unseen()
    {
        // At 20 m the image ends at x = 20 tan(25 deg) 4/3 = 12.4 m: the post stands outside, the empty half of its cuboid inside.
        var post = new Cuboid(new(14.5, 20, 0), new(0.5, 0.5, 1), Axes.Identity);
        var withGap = new Cuboid(new(13, 20, 0), new(2, 0.5, 1), Axes.Identity);
        var wall = new Cuboid(new(0, 30, 0), new(60, 1, 9), Axes.Identity);

        AdaptivePixelMap map = MapRun.Complete(
            SmallWorld.Camera,
            new CuboidWorld([(5, post), (6, wall)]),
            [SmallWorld.Target(5, 1, withGap), SmallWorld.Target(6, 2, wall)]
        );

        Assert.Equal((Sight.Unseen, Sight.Seen), (map.Sights[1], map.Sights[2]));
        Assert.Null(map.Map.BoundsOf(1));
    }

    [Fact]
    public void Run_beyond_the_reach_of_rays_is_undetermined_without_rays()
    {
        var car = new Cuboid(new(0, 200, 0), new(2, 1, 1), Axes.Identity);
        var world = new CuboidWorld([]);
        var mapper = new AdaptivePixelMapper(
            SmallWorld.Camera,
            [SmallWorld.Target(6, 2, car)],
            RayHit.World,
            world,
            new PixelMapOptions { RayReachMetres = 100 }
        );

        mapper.Run();
        AdaptivePixelMap map = mapper.Finish();

        Assert.Equal(0, world.RaysCast);
        Assert.Equal(Sight.Undetermined, map.Sights[2]);
        Assert.Null(map.Map.BoundsOf(2));
    }

    [Fact]
    public void Run_marks_a_distant_object_that_no_ray_hits_as_undetermined()
    {
        // At 400 m it is 3 x 1.5 pixels: fewer rays than four go through its cuboid.
        var ghost = new Cuboid(new(0, 400, 0), new(1.5, 1, 0.75), Axes.Identity);

        AdaptivePixelMap map = MapRun.Complete(SmallWorld.Camera, new CuboidWorld([]), [SmallWorld.Target(6, 2, ghost)]);

        Assert.Equal(Sight.Undetermined, map.Sights[2]);
    }

    [Fact]
    public void Run_without_rays_leaves_targets_not_asked()
    {
        var car = new Cuboid(new(0, 20, 0), new(2, 1, 1), Axes.Identity);
        var mapper = new AdaptivePixelMapper(
            SmallWorld.Camera,
            [SmallWorld.Target(6, 2, car)],
            RayHit.World,
            new CuboidWorld([(6, car)]),
            new PixelMapOptions { RayBudget = 0 }
        );

        mapper.Run();
        AdaptivePixelMap map = mapper.Finish();

        Assert.Equal(Sight.NotAsked, map.Sights[2]);
        Assert.Null(map.Map.BoundsOf(2));
    }
}
