using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Roads.Sources;

/// <summary>What the two older forms of the path data, paths.ipl and paths.xml, say in the same numbers.</summary>
internal static class TextRoadFields
{
    /// <summary>The most lanes that a direction has in the game's own format.</summary>
    public const int MaxLanes = 7;

    /// <summary>The least and greatest width of a median; the game's files have -10 to 10.</summary>
    public const int MaxWidth = 1000;

    private const double DensitySteps = 15;

    /// <summary>A density from 0 to 1 as the steps of the game, 0 to 15.</summary>
    public static int Density(double fraction) => (int)System.Math.Round(System.Math.Clamp(fraction, 0, 1) * DensitySteps);

    /// <summary>Width of the median; negative widths mean that nothing is known of it.</summary>
    public static double? Median(int width) => width < 0 ? null : width;

    /// <summary>A speed from 0 to 3.</summary>
    public static RoadSpeed Speed(int speed) => (RoadSpeed)speed;
}
