using System;
using System.Linq;

namespace Harvester.Sessions.Rigs;

/// <summary>Estimates how long a moment of a rig takes, so that an unreasonable rig is refused before a harvest begins.</summary>
public static class RigBudget
{
    /// <summary>Longest moment that is harvested, seconds.</summary>
    public const double MaxSeconds = 60;

    /// <summary>Rendered pixels per second on one core, an order of magnitude.</summary>
    private const double PixelsPerSecond = 5e6;

    /// <summary>Rays per second on one core, an order of magnitude.</summary>
    private const double RaysPerSecond = 3e5;

    /// <summary>Labels of one view, seconds, an order of magnitude.</summary>
    private const double LabelSeconds = 0.02;

    /// <summary>An estimate of the seconds that one moment takes in the simulated game on one core.</summary>
    public static double SecondsPerMoment(Rig rig)
    {
        _ = rig ?? throw new ArgumentNullException(nameof(rig));
        return rig.Cameras.Sum(camera => LabelSeconds + ((double)camera.Image.Width * camera.Image.Height / PixelsPerSecond))
            + rig.Lidars.Sum(lidar => lidar.RayFraction * lidar.Rays / RaysPerSecond);
    }
}
