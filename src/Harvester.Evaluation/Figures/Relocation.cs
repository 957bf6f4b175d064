using System;

namespace Harvester.Evaluation.Figures;

/// <summary>Tells a car that was put elsewhere from one that has driven there.</summary>
public static class Relocation
{
    /// <summary>No car moves further than this beyond twice its speed, metres: what its middle swings by in a turn on the spot.</summary>
    private const double LittleWay = 1;

    /// <summary>Whether no car drives so far in the time.</summary>
    /// <param name="metres">How far it is from where it was.</param>
    /// <param name="speedBefore">Its speed there, m/s.</param>
    /// <param name="speedNow">Its speed here, m/s.</param>
    /// <param name="seconds">Time between.</param>
    public static bool Is(double metres, double speedBefore, double speedNow, double seconds) =>
        metres > LittleWay + (2 * Math.Max(speedBefore, speedNow) * Math.Max(0, seconds));
}
