namespace Harvester.Runs.Evaluation.Figures;

/// <summary>Distinguishes a teleported car from one that has driven.</summary>
public static class Relocation
{
    /// <summary>
    /// Largest distance beyond twice the speed that a car can move between samples, metres: the swing of its centre when it turns on the
    /// spot.
    /// </summary>
    private const double LittleWay = 1;

    /// <summary>Whether a car cannot have driven a distance in a time.</summary>
    /// <param name="metres">Distance from the previous position, metres.</param>
    /// <param name="speedBefore">Speed at the previous position, m/s.</param>
    /// <param name="speedNow">Speed at the current position, m/s.</param>
    /// <param name="seconds">Time between, seconds.</param>
    public static bool Is(double metres, double speedBefore, double speedNow, double seconds) =>
        metres > LittleWay + (2 * Math.Max(speedBefore, speedNow) * Math.Max(0, seconds));
}
