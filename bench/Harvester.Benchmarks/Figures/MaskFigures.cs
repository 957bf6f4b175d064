using System.Diagnostics;
using Harvester.Benchmarks.PixelMaps;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;

namespace Harvester.Benchmarks.Figures;

/// <summary>What a mask of 800 x 600 costs besides its rays: the median of seeded scenes, each the best of its runs.</summary>
internal static class MaskFigures
{
    private const int Scenes = 15;
    private const int FirstSeed = 1000;
    private const int Runs = 6;

    public static void Run()
    {
        // The first round ends when all hot code has been compiled for good.
        OfAllScenes();
        FigureLine.Write("map.own_milliseconds", OfAllScenes()[Scenes / 2]);
    }

    private static double[] OfAllScenes() => [.. Enumerable.Range(0, Scenes).Select(OwnMilliseconds).Order()];

    private static double OwnMilliseconds(int number)
    {
        var scene = new TownScene(FirstSeed + number, TownScene.ObjectsOf(number), new ImageSize(800, 600));
        List<MapTarget> targets = scene.Targets();
        double best = double.PositiveInfinity;
        for (int run = 0; run < Runs; run++)
        {
            var rays = new TimedRays(scene);
            var watch = Stopwatch.StartNew();
            var mapper = new AdaptivePixelMapper(scene.Camera, targets, RayHit.World, rays, new PixelMapOptions());
            mapper.Run();
            mapper.Finish();
            best = Math.Min(best, (watch.Elapsed - rays.Elapsed).TotalMilliseconds);
        }

        return best;
    }
}
