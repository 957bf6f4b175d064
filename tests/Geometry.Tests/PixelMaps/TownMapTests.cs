using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;
using Harvester.TestSupport;

namespace Harvester.Geometry.Tests.PixelMaps;

/// <summary>Adaptive maps of the seeded streets against exhaustive ones.</summary>
public sealed class TownMapTests
{
    /// <summary>Scenes on which the options were not tuned, though what went wrong there was looked into.</summary>
    private const int OtherSeeds = 5000;

    /// <summary>Scenes of which nothing but the figures was looked at, apart from two in which something went wrong.</summary>
    private const int HeldOutSeeds = 9000;

    private static readonly ImageSize Size = new(800, 600);

    [Fact]
    public void Run_a_few_town_scenes_agree_with_the_exhaustive_maps()
    {
        var scores = new MapScores();
        foreach (int number in (int[])[3, 22, 31])
        {
            TownScene scene = TownScene.Numbered(number, Size);
            AdaptivePixelMapper mapper = MapRun.Of(scene, scene.Targets(), new PixelMapOptions());
            Assert.True(mapper.Run());
            AdaptivePixelMap map = mapper.Finish();
            Assert.True(map.IsComplete);
            scores.Add(scene.ExhaustiveMap(), map.Map, map.RaysCast);
        }

        AssertAsDemanded(scores, 0.01);
    }

    [Theory]
    [Trait("Category", "Heavy")]
    [InlineData(800, 600, OtherSeeds, 0.01)]
    [InlineData(1920, 1080, HeldOutSeeds, 0.005)]
    public void Run_many_town_scenes_agree_with_the_exhaustive_maps(int width, int height, int firstSeed, double maxRayFraction)
    {
        var maps = ParallelEnumerable
            .Range(0, ProofSize.Of(inCi: 25, full: 50))
            .AsOrdered()
            .Select(number =>
            {
                var scene = new TownScene(firstSeed + number, TownScene.ObjectsOf(number), new ImageSize(width, height));
                AdaptivePixelMapper mapper = MapRun.Of(scene, scene.Targets(), new PixelMapOptions());
                mapper.Run();
                return (Exhaustive: scene.ExhaustiveMap(), Adaptive: mapper.Finish());
            });
        var scores = new MapScores();
        foreach ((InstanceMap exhaustive, AdaptivePixelMap adaptive) in maps)
        {
            scores.Add(exhaustive, adaptive.Map, adaptive.RaysCast);
        }

        AssertAsDemanded(scores, maxRayFraction);
    }

    [Fact]
    public void ExhaustiveMap_of_the_boxes_equals_that_of_the_whole_image()
    {
        TownScene scene = TownScene.Numbered(40, new ImageSize(320, 240));

        InstanceMap whole = ExhaustivePixelMapper.Map(
            scene.Camera,
            scene.Camera.Image.Bounds,
            entity => (ushort)entity,
            RayHit.World,
            scene
        );

        Assert.True(whole.Ids.Distinct().Count() > 10);
        Assert.Equal(whole.Ids, scene.ExhaustiveMap().Ids);
    }

    private static void AssertAsDemanded(MapScores scores, double maxRayFraction)
    {
        Assert.InRange(scores.Large.Average(), 0.99, 1);
        Assert.InRange(scores.Large.Min(), 0.95, 1);
        Assert.InRange(scores.Medium.Average(), 0.97, 1);
        Assert.InRange(scores.SmallFound.Average(found => found ? 1.0 : 0), 0.99, 1);
        Assert.InRange(scores.MeanRayFraction, 0, maxRayFraction);
        Assert.InRange(scores.MaxFractionOfAllowedRays, 0, 1);
    }
}
