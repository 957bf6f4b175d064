using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Roads.Sources;

/// <summary>The numbers that paths.ipl and paths.xml, the two older formats of the path data, have in common.</summary>
internal static class TextRoadFields
{
    /// <summary>Largest number of lanes per direction in the game's format.</summary>
    public const int MaxLanes = 7;

    /// <summary>Largest width of a median, positive or negative; the game's files have -10 to 10.</summary>
    public const int MaxWidth = 1000;

    private const double DensitySteps = 15;

    /// <summary>A density from 0 to 1, as the game's steps from 0 to 15.</summary>
    public static int Density(double fraction) => (int)System.Math.Round(System.Math.Clamp(fraction, 0, 1) * DensitySteps);

    /// <summary>Width of the median; negative widths mean that it is unknown.</summary>
    public static double? Median(int width) => width < 0 ? null : width;

    /// <summary>A speed class from 0 to 3.</summary>
    public static RoadSpeed Speed(int speed) => (RoadSpeed)speed;
}
