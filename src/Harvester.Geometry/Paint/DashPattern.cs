namespace Harvester.Geometry.Paint;

/// <summary>The dashes of a dashed line along a link: dash k is painted from Phase + k · Period to Phase + k · Period + Length.</summary>
/// <param name="Length">Length of a dash, metres; greater than 0.</param>
/// <param name="Period">Distance from the start of a dash to the start of the next, metres; greater than the length.</param>
/// <param name="Phase">Station on the link where a dash starts, metres; from 0 to the period.</param>
public readonly record struct DashPattern(double Length, double Period, double Phase)
{
    /// <summary>Whether there is paint at a station, metres from the link's start.</summary>
    public bool IsPainted(double station)
    {
        double place = (station - Phase) / Period;
        return (place - System.Math.Floor(place)) * Period <= Length;
    }
}
