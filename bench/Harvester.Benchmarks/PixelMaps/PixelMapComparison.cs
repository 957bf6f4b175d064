using System.Diagnostics;
using System.Globalization;
using System.Text;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;

namespace Harvester.Benchmarks.PixelMaps;

/// <summary>
/// Compares strategies for pixel maps on the 50 seeded scenes: rays, agreement with the exhaustive map and time, scene by scene and in
/// all, and draws agreement over ray budget. Arguments: width, height, first seed (1000 for the scenes of the tests), SVG file.
/// </summary>
internal static class PixelMapComparison
{
    private const int Scenes = 50;
    private static readonly double[] BudgetFractions = [0, 0.0005, 0.001, 0.002, 0.003, 0.004, 0.006, 0.008, 0.010, 0.015, 0.02];

    public static void Run(ImageSize size, int firstSeed, string? picture)
    {
        string[] names = ["cells", "quadtree", "contours", "scanlines"];
        MapScores[] scores = [.. names.Select(_ => new MapScores())];
        MapScores[] budgets = [.. BudgetFractions.Select(_ => new MapScores())];
        Console.WriteLine("scene  objects  rays  of all   mean IoU  least IoU  ms");
        for (int number = 0; number < Scenes; number++)
        {
            var scene = new TownScene(firstSeed + number, TownScene.ObjectsOf(number), size);
            List<MapTarget> targets = scene.Targets();
            InstanceMap exact = scene.ExhaustiveMap();
            var watch = Stopwatch.StartNew();
            AdaptivePixelMap map = Cells(scene, targets, int.MaxValue);
            double milliseconds = watch.Elapsed.TotalMilliseconds;
            var own = new MapScores();
            own.Add(exact, map.Map, map.RaysCast);
            Write($"{number,5}  {targets.Count,7}  {map.RaysCast,5}  {own.MeanRayFraction,6:P2}  {own.Large.DefaultIfEmpty(1).Average(),8:F4}  {own.Large.DefaultIfEmpty(1).Min(),9:F4}  {milliseconds:F0}");
            scores[0].Add(exact, map.Map, map.RaysCast);
            AddOther(scores[1], exact, scene, targets, image => Quadtree.Map(image, 16));
            AddOther(scores[2], exact, scene, targets, image => ContourFollowing.Map(image, 16));
            AddOther(scores[3], exact, scene, targets, image => GuidedScanlines.Map(image, targets, 8, 16));
            for (int i = 0; i < budgets.Length && picture is not null; i++)
            {
                AdaptivePixelMap stopped = Cells(scene, targets, (int)(BudgetFractions[i] * size.PixelCount));
                budgets[i].Add(exact, stopped.Map, stopped.RaysCast);
            }
        }

        Console.WriteLine("strategy    rays    large: mean  least   under 0.95   medium: mean   small found   of allowed rays at most");
        for (int i = 0; i < names.Length; i++)
        {
            MapScores s = scores[i];
            Write($"{names[i],-10}  {s.MeanRayFraction,6:P3}  {s.Large.Average(),11:F4}  {s.Large.Min():F4}  {s.Large.Count(iou => iou < 0.95),3} of {s.Large.Count,3}  {s.Medium.Average(),13:F4}  {s.SmallFound.Average(found => found ? 1.0 : 0),12:P1}  {s.GreatestShareOfAllowedRays:F2}");
        }

        if (picture is not null)
        {
            File.WriteAllText(picture, BudgetCurve.Draw(size, BudgetFractions, budgets), new UTF8Encoding(false));
        }
    }

    private static void Write(FormattableString line) => Console.WriteLine(line.ToString(CultureInfo.InvariantCulture));

    private static AdaptivePixelMap Cells(TownScene scene, IReadOnlyList<MapTarget> targets, int budget)
    {
        var mapper = new AdaptivePixelMapper(scene.Camera, targets, RayHit.World, scene, new PixelMapOptions { RayBudget = budget });
        mapper.Run();
        return mapper.Finish();
    }

    private static void AddOther(
        MapScores scores, InstanceMap exact, TownScene scene, IReadOnlyList<MapTarget> targets, Func<SampledImage, InstanceMap> strategy)
    {
        var image = new SampledImage(scene, targets);
        InstanceMap map = strategy(image);
        scores.Add(exact, map, image.Rays);
    }
}
