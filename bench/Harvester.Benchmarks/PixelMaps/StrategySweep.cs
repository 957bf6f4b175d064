using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;

namespace Harvester.Benchmarks.PixelMaps;

/// <summary>
/// Ways to make pixel maps, each at several settings, on the 50 seeded scenes against the exhaustive maps. All start with a few rays in
/// every object's box, cast none outside the boxes, and pay once for a pixel. Arguments: width, height, first seed.
/// </summary>
internal static class StrategySweep
{
    private const int Scenes = 50;
    private static readonly PixelMapOptions Cells = new();

    private static readonly (string Name, Func<TownScene, List<MapTarget>, (InstanceMap Map, int Rays)> Way)[] Ways =
    [
        .. new[] { 0.5, 1.0, 2.0, 4.0 }.Select(rougher => ($"cells, {rougher} times the error", ByCells(rougher))),
        .. new[] { 6, 8, 10, 14 }.Select(step => ($"uniform grid of {step}", ByPixels((image, _) => image.Nearest(step)))),
        .. new[] { 8, 16, 32, 64 }.Select(size => ($"quadtree, first grid {size}", ByPixels((image, _) => Quadtree.Map(image, size, 1)))),
        .. new[] { 8, 16, 32 }.Select(size =>
            ($"quadtree down to 2 pixels, first grid {size}", ByPixels((image, _) => Quadtree.Map(image, size, 2)))
        ),
        .. new[] { 8, 16, 32, 64 }.Select(size =>
            ($"boundary tracing, first grid {size}", ByPixels((image, _) => ContourFollowing.Map(image, size)))
        ),
        .. new[] { (4, 32), (8, 16), (8, 32), (16, 32), (32, 64) }.Select(step =>
            (
                $"hull-guided scanlines, every {step.Item1} rows and {step.Item2} columns",
                ByPixels((image, targets) => GuidedScanlines.Map(image, targets, step.Item1, step.Item2))
            )
        ),
    ];

    public static void Run(ImageSize size, int firstSeed)
    {
        MapScores[] scores = [.. Ways.Select(_ => new MapScores())];
        for (int number = 0; number < Scenes; number++)
        {
            var scene = new TownScene(firstSeed + number, TownScene.ObjectsOf(number), size);
            List<MapTarget> targets = scene.Targets();
            InstanceMap exact = scene.ExhaustiveMap();
            for (int i = 0; i < Ways.Length; i++)
            {
                (InstanceMap map, int rays) = Ways[i].Way(scene, targets);
                scores[i].Add(exact, map, rays);
            }
        }

        Console.WriteLine(ScoreLine.Heading);
        for (int i = 0; i < Ways.Length; i++)
        {
            Console.WriteLine(ScoreLine.Of(Ways[i].Name, scores[i]));
        }
    }

    private static Func<TownScene, List<MapTarget>, (InstanceMap Map, int Rays)> ByCells(double rougher) =>
        (scene, targets) =>
        {
            var options = new PixelMapOptions
            {
                CellErrorFraction = Cells.CellErrorFraction * rougher,
                StraightCellFraction = Cells.StraightCellFraction * rougher,
                UnsearchedFraction = Cells.UnsearchedFraction * rougher,
            };
            var mapper = new AdaptivePixelMapper(scene.Camera, targets, RayHit.World, scene, options);
            mapper.Run();
            AdaptivePixelMap map = mapper.Finish();
            return (map.Map, map.RaysCast);
        };

    private static Func<TownScene, List<MapTarget>, (InstanceMap Map, int Rays)> ByPixels(
        Func<SampledImage, List<MapTarget>, InstanceMap> strategy
    ) =>
        (scene, targets) =>
        {
            var image = new SampledImage(scene, targets);
            InstanceMap map = strategy(image, targets);
            return (map, image.Rays);
        };
}
