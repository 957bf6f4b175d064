using System.Globalization;
using Harvester.Geometry.Tests.Scenes;

namespace Harvester.Benchmarks.PixelMaps;

/// <summary>Scores as a row of a table in Markdown.</summary>
internal static class ScoreLine
{
    public const string Heading =
        "| way | rays, mean | IoU from 256 px, mean | least | under 0.95 | IoU of 64 to 256 px, mean | found of 16 to 64 px | most of the "
        + "allowed rays in a scene |\n"
        + "|---|---|---|---|---|---|---|---|";

    public static string Of(string name, MapScores s) =>
        string.Create(
            CultureInfo.InvariantCulture,
            $"| {name} | {s.MeanRayFraction * 100:F3} % | {s.Large.Average():F4} | {s.Large.Min():F3} | "
                + $"{s.Large.Count(iou => iou < 0.95)} of "
                + $"{s.Large.Count} | {s.Medium.Average():F4} | {s.SmallFound.Average(found => found ? 100.0 : 0):F1} % | "
                + $"{s.MaxFractionOfAllowedRays:F2} |"
        );
}
