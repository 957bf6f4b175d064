using System.Diagnostics;
using System.Globalization;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;

namespace Harvester.Benchmarks.PixelMaps;

/// <summary>
/// Adaptive pixel maps of the 50 seeded scenes: rays, agreement with the exhaustive map and the mapper's own time, scene by scene and in
/// all, and agreement over ray budget as a picture. Arguments: width, height, first seed (1000 for the scenes of the tests), SVG file.
/// </summary>
internal static class PixelMapComparison
{
    private const int Scenes = 50;

    /// <summary>The least time of this many runs is that of a run that nothing else disturbed.</summary>
    private const int Runs = 5;

    /// <summary>What a ray through a game's scripting interface is taken to cost, milliseconds.</summary>
    private const double QuickRay = 0.02;
    private const double SlowRay = 0.1;
    private static readonly double[] BudgetFractions = [0, 0.0005, 0.001, 0.002, 0.003, 0.004, 0.006, 0.008, 0.010, 0.015, 0.02];

    public static void Run(ImageSize size, int firstSeed, string? picture)
    {
        var scores = new MapScores();
        var rays = new List<double>();
        var times = new List<double>();
        MapScores[] budgets = [.. BudgetFractions.Select(_ => new MapScores())];
        Console.WriteLine("scene  objects   rays  of all   mean IoU  least IoU  own ms");
        for (int number = 0; number < Scenes; number++)
        {
            var scene = new TownScene(firstSeed + number, TownScene.ObjectsOf(number), size);
            InstanceMap exact = scene.ExhaustiveMap();
            (AdaptivePixelMap map, double milliseconds) = Mapped(scene, int.MaxValue);
            for (int run = 1; run < Runs; run++)
            {
                milliseconds = Math.Min(milliseconds, Mapped(scene, int.MaxValue).Milliseconds);
            }

            var own = new MapScores();
            own.Add(exact, map.Map, map.RaysCast);
            Console.WriteLine(
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"{number, 5}  {TownScene.ObjectsOf(number), 7}  {map.RaysCast, 5}  {own.MeanRayFraction, 6:P2}  "
                        + $"{own.Large.DefaultIfEmpty(1).Average(), 8:F4}  {own.Large.DefaultIfEmpty(1).Min(), 9:F4}  {milliseconds, 6:F0}"
                )
            );
            scores.Add(exact, map.Map, map.RaysCast);
            rays.Add(map.RaysCast);
            times.Add(milliseconds);
            for (int i = 0; i < budgets.Length && picture is not null; i++)
            {
                (AdaptivePixelMap stopped, _) = Mapped(scene, (int)(BudgetFractions[i] * size.PixelCount));
                budgets[i].Add(exact, stopped.Map, stopped.RaysCast);
            }
        }

        Console.WriteLine(ScoreLine.Heading);
        Console.WriteLine(ScoreLine.Of("cells", scores));
        rays.Sort();
        times.Sort();
        foreach ((string name, double share) in new[] { ("median", 0.5), ("9 of 10", 0.9), ("greatest", 1.0) })
        {
            int at = (int)Math.Ceiling(share * (Scenes - 1));
            Console.WriteLine(
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"{name, -9} rays {rays[at], 6:F0}: {rays[at] * QuickRay, 5:F0} to {rays[at] * SlowRay, 5:F0} ms at "
                        + $"{QuickRay} to {SlowRay} "
                        + $"ms each; own time {times[at], 4:F0} ms"
                )
            );
        }

        if (picture is not null)
        {
            using FileStream file = File.Create(picture);
            BudgetCurve.Write(file, size, BudgetFractions, budgets);
        }
    }

    private static (AdaptivePixelMap Map, double Milliseconds) Mapped(TownScene scene, int budget)
    {
        List<MapTarget> targets = scene.Targets();
        var rays = new TimedRays(scene);
        var watch = Stopwatch.StartNew();
        var mapper = new AdaptivePixelMapper(scene.Camera, targets, RayHit.World, rays, new PixelMapOptions { RayBudget = budget });
        mapper.Run();
        AdaptivePixelMap map = mapper.Finish();
        return (map, (watch.Elapsed - rays.Elapsed).TotalMilliseconds);
    }
}
