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
    public void Run_maps_a_thin_object_almost_exactly(double half, double halfHeight)
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
    public void Run_finds_thin_arms_that_fill_little_of_their_cuboid()
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

    [Fact]
    public void Run_of_an_object_that_fills_the_image_takes_few_rays()
    {
        // 1920 x 1080 has 60 x 34 cells, with 2,135 corners. The map has no outline, so 1,000 rays are allowed.
        var size = new ImageSize(1920, 1080);
        Camera camera = SmallWorld.Sized(size);
        var bus = new Cuboid(new(0, 4, 0), new(9, 0.5, 9), Axes.Identity);
        List<(int Entity, Cuboid Solid)> solids = [(1, bus)];
        for (int i = 2; i <= 30; i++)
        {
            solids.Add((i, new Cuboid(new((i - 16) * 0.6, 10 + i, 0), new(1, 2, 1), Axes.Identity)));
        }

        AdaptivePixelMap map = MapRun.Complete(
            camera,
            new CuboidWorld(solids),
            [
                .. solids.Select(item => new MapTarget(
                    item.Entity,
                    (ushort)item.Entity,
                    item.Solid,
                    CuboidProjector.Project(camera, item.Solid)
                )),
            ]
        );

        Assert.Equal(size.PixelCount, map.Map.MapOf(1).Count);
        Assert.InRange(map.RaysCast, 1, 1000);
    }

    [Theory]
    [InlineData(0.0)]
    [InlineData(8.0)]
    public void Run_narrow_gap_in_an_object_is_followed_to_its_ends(double leanDegrees)
    {
        // At 12 m a pixel is 12 / 643 = 0.0187 m: legs of 13 x 54 px with a gap of 2 px between them, upright or leaning.
        Axes lean = Axes.FromEuler(new EulerAngles(0, leanDegrees, 0));
        var left = new Cuboid(lean.ToWorld(new(-0.145, 0, 0)) + new Vector3D(0.4, 12, 0), new(0.125, 0.1, 0.5), lean);
        var right = new Cuboid(lean.ToWorld(new(0.145, 0, 0)) + new Vector3D(0.4, 12, 0), new(0.125, 0.1, 0.5), lean);
        var both = new Cuboid(new(0.4, 12, 0), new(0.27, 0.1, 0.5), lean);
        var world = new CuboidWorld([(7, left), (7, right)]);
        InstanceMap exact = ExhaustivePixelMapper.Map(SmallWorld.Camera, SmallWorld.Camera.Image.Bounds, _ => 1, RayHit.World, world);

        AdaptivePixelMap map = MapRun.Complete(SmallWorld.Camera, world, [SmallWorld.Target(7, 1, both)]);

        var scores = new MapScores();
        scores.Add(exact, map.Map, map.RaysCast);
        Assert.True(scores.Large.Single() >= 0.97, $"{scores.Large.Single()}");
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
