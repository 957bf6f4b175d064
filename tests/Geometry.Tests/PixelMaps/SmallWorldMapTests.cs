using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.Tests.PixelMaps;

/// <summary>Maps of worlds of a few cuboids.</summary>
public sealed class SmallWorldMapTests
{
    [Theory]
    [InlineData(0.04, 2.0)]
    [InlineData(0.1, 0.9)]
    public void Run_thin_thing_is_found_and_nearly_exact(double half, double halfHeight)
    {
        // At 30 m a pixel is 30 / 643 = 0.047 m: a pole of 1.7 px and a pedestrian's width of 4.3 px.
        var thing = new Cuboid(new(1.3, 30, 0.2), new(half, half, halfHeight), Axes.FromHeading(20));
        var world = new CuboidWorld([(7, thing)]);
        InstanceMap exact = ExhaustivePixelMapper.Map(SmallWorld.Camera, SmallWorld.Camera.Image.Bounds, _ => 1, RayHit.World, world);

        AdaptivePixelMap map = MapRun.Complete(SmallWorld.Camera, world, [SmallWorld.Target(7, 1, thing)]);

        var scores = new MapScores();
        scores.Add(exact, map.Map, map.RaysCast);
        Assert.True(scores.Large.Concat(scores.Medium).Single() >= 0.95);
    }

    [Fact]
    public void Run_thin_arms_of_an_object_that_fills_little_of_its_cuboid_are_found()
    {
        // A traffic light at 40 m, where a pixel is 40 / 643 = 0.062 m: a pole of 2 px and an arm of 64 px by 2 px in a box of 64 by 97 px.
        var pole = new Cuboid(new(2, 40, 0), new(0.06, 0.06, 3), Axes.Identity);
        var arm = new Cuboid(new(0.06, 40, 2.7), new(2, 0.06, 0.06), Axes.Identity);
        var bounds = new Cuboid(new(0.06, 40, 0), new(2, 0.06, 3), Axes.Identity);
        var world = new CuboidWorld([(7, pole), (7, arm)]);
        InstanceMap exact = ExhaustivePixelMapper.Map(SmallWorld.Camera, SmallWorld.Camera.Image.Bounds, _ => 1, RayHit.World, world);

        AdaptivePixelMap map = MapRun.Complete(SmallWorld.Camera, world, [SmallWorld.Target(7, 1, bounds)]);

        var scores = new MapScores();
        scores.Add(exact, map.Map, map.RaysCast);
        Assert.True(scores.Large.Concat(scores.Medium).Single() >= 0.95);
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(1, 40)]
    [InlineData(33, 2)]
    [InlineData(65, 65)]
    public void Run_image_of_any_size_is_mapped(int width, int height)
    {
        Camera camera = SmallWorld.Sized(new ImageSize(width, height));
        var wall = new Cuboid(new(0, 10, 0), new(90, 0.2, 90), Axes.Identity);
        var world = new CuboidWorld([(3, wall)]);

        AdaptivePixelMap map = MapRun.Complete(camera, world, [new MapTarget(3, 9, wall, CuboidProjector.Project(camera, wall))]);

        Assert.Equal(width * height, map.Map.MapOf(9).Count);
    }
}
