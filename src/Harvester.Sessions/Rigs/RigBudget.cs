namespace Harvester.Sessions.Rigs;

/// <summary>Estimates how long a moment of a rig takes, so that an unreasonable rig is refused before a harvest begins.</summary>
public static class RigBudget
{
    /// <summary>Longest moment that is harvested, seconds.</summary>
    public const double MaxSeconds = 60;

    /// <summary>Rendered pixels per second on one core, an order of magnitude.</summary>
    private const double PixelsPerSecond = 5e6;

    /// <summary>Pixels of masks per second on one core: 0.14 s for six masks of 800x450.</summary>
    private const double MaskPixelsPerSecond = 1.5e7;

    /// <summary>Pixels of depth maps per second on one core: 0.7 s for six maps of 800x450.</summary>
    private const double DepthPixelsPerSecond = 3e6;

    /// <summary>Rays per second on one core, an order of magnitude.</summary>
    private const double RaysPerSecond = 3e5;

    /// <summary>Labels of one view, seconds, an order of magnitude.</summary>
    private const double LabelSeconds = 0.02;

    /// <summary>Part of the pixels through which the rays of a mask and those of a depth map go.</summary>
    private const double MaskRayFraction = 0.01;
    private const double DepthRayFraction = 0.04;

    /// <summary>An estimate of the seconds that one moment takes in the simulated game on one core.</summary>
    /// <param name="rig">The rig.</param>
    /// <param name="masks">Whether each view has a mask.</param>
    /// <param name="depth">Whether each view has depth maps.</param>
    /// <exception cref="ArgumentNullException"><paramref name="rig"/> is null.</exception>
    public static double SecondsPerMoment(Rig rig, bool masks = false, bool depth = false)
    {
        double perPixel = (1 / PixelsPerSecond) + (masks ? 1 / MaskPixelsPerSecond : 0) + (depth ? 1 / DepthPixelsPerSecond : 0);
        return (Pixels(rig) * perPixel) + (LabelSeconds * rig.Cameras.Count) + (LidarRays(rig) / RaysPerSecond);
    }

    /// <summary>An estimate of the rays of one moment.</summary>
    /// <param name="rig">The rig.</param>
    /// <param name="masks">Whether each view has a mask.</param>
    /// <param name="depth">Whether each view has depth maps.</param>
    /// <exception cref="ArgumentNullException"><paramref name="rig"/> is null.</exception>
    public static double RaysPerMoment(Rig rig, bool masks, bool depth) =>
        (Pixels(rig) * ((masks ? MaskRayFraction : 0) + (depth ? DepthRayFraction : 0))) + LidarRays(rig);

    /// <summary>Why a rig cannot be harvested, as a sentence with the estimate; null if it can.</summary>
    /// <param name="rig">The rig.</param>
    /// <param name="secondsPerMoment">The estimate, seconds.</param>
    /// <exception cref="ArgumentNullException"><paramref name="rig"/> is null.</exception>
    public static string? ProblemOf(Rig rig, double secondsPerMoment)
    {
        _ = rig ?? throw new ArgumentNullException(nameof(rig));
        return secondsPerMoment <= MaxSeconds
            ? null
            : FormattableString.Invariant(
                $"A moment of the rig '{rig.Name}' takes about {secondsPerMoment:0} s; at most {MaxSeconds} s are allowed. "
            ) + "Give it fewer rays or smaller images.";
    }

    private static double Pixels(Rig rig) =>
        (rig ?? throw new ArgumentNullException(nameof(rig))).Cameras.Sum(camera => (double)camera.Image.Width * camera.Image.Height);

    private static double LidarRays(Rig rig) =>
        rig.Lidars.Sum(lidar => lidar.RayFraction * lidar.Rays) + rig.Radars.Sum(static radar => (double)radar.Rays);
}
