using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;

namespace Harvester.Geometry.Tests.PixelMaps;

/// <summary>Maps that are made in steps or stopped before they are complete.</summary>
public sealed class StoppedMapTests
{
    private static readonly ImageSize Size = new(800, 600);

    [Fact]
    public void Step_by_step_with_maps_taken_between_gives_the_same_map()
    {
        TownScene scene = TownScene.Numbered(6, Size);
        List<MapTarget> targets = scene.Targets();
        AdaptivePixelMap whole = MapRun.Complete(scene, targets);
        AdaptivePixelMapper mapper = MapRun.Of(scene, targets, new PixelMapOptions());

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
    public void Run_with_more_rays_gives_better_maps_and_reports_quality()
    {
        TownScene scene = TownScene.Numbered(20, Size);
        List<MapTarget> targets = scene.Targets();
        InstanceMap exact = scene.ExhaustiveMap();
        double before = -1;
        int resolutionBefore = int.MaxValue;
        foreach (int budget in (int[])[0, 500, 1500, 5000])
        {
            AdaptivePixelMapper mapper = MapRun.Of(scene, targets, new PixelMapOptions { RayBudget = budget });
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

    [Theory]
    [InlineData(300)]
    [InlineData(1000)]
    [InlineData(3000)]
    public void Run_of_few_rays_shows_no_object_beyond_the_box_of_its_cuboid(int budget)
    {
        TownScene scene = TownScene.Numbered(20, Size);
        List<MapTarget> targets = scene.Targets();

        AdaptivePixelMapper mapper = MapRun.Of(scene, targets, new PixelMapOptions { RayBudget = budget, RayReachMetres = 40 });
        mapper.Run();
        InstanceMap map = mapper.Finish().Map;

        Assert.All(
            targets,
            target =>
                Assert.True(map.BoundsOf(target.Number) is not { } seen || (target.Projection.Box is { } box && box.Contains(seen, 1)))
        );
    }

    [Fact]
    public void Run_without_rays_shows_nothing()
    {
        TownScene scene = TownScene.Numbered(9, Size);
        List<MapTarget> targets = scene.Targets();
        AdaptivePixelMapper mapper = MapRun.Of(scene, targets, new PixelMapOptions { RayBudget = 0 });

        mapper.Run();
        AdaptivePixelMap map = mapper.Finish();

        Assert.All(map.Map.Ids, id => Assert.Equal(0, id));
        Assert.Equal(0, map.RaysCast);
        Assert.False(map.IsComplete);
    }

    [Fact]
    public void Run_stops_after_a_ray_when_time_is_up_and_resumes_later()
    {
        TownScene scene = TownScene.Numbered(2, Size);
        AdaptivePixelMapper mapper = MapRun.Of(scene, scene.Targets(), new PixelMapOptions());

        Assert.False(mapper.Run(() => true));
        Assert.Equal(1, mapper.RaysCast);
        Assert.False(mapper.Run(() => mapper.RaysCast >= 100));
        Assert.Equal(100, mapper.RaysCast);
        Assert.True(mapper.Run());
        Assert.True(mapper.IsComplete);
    }
}
