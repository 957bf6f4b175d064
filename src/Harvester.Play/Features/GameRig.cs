using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>
/// A rig as the game can show it. Its pictures are those of the game's window, scaled to the size of each camera; the vertical field of
/// view is the camera's, the horizontal one follows from the shape of the window; the lens is the game's own.
/// </summary>
public static class GameRig
{
    /// <summary>Relative difference of shapes that shows nowhere: half a pixel of 1,000.</summary>
    private const double AspectTolerance = 5e-4;

    /// <summary>The widest vertical field of view of a camera of the game, degrees.</summary>
    private const double MaxFovDegrees = 130;

    /// <summary>Rays per tick that leave the game responsive, and ticks per second, as in docs/rigs.md.</summary>
    private const double RaysPerTick = 1000;
    private const double TicksPerSecond = 60;

    /// <summary>Ticks of a view besides those that its picture may lag: to move the camera and to label.</summary>
    private const int TicksOfView = 2;

    /// <summary>The options of a harvest with a rig.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="options"/> is null.</exception>
    public static HarvestOptions AppliedTo(HarvestOptions options, Rig? rig)
    {
        _ = options ?? throw new ArgumentNullException(nameof(options));
        if (rig is null)
        {
            return options;
        }

        Lens lens = options.Lens;
        return options with
        {
            Rig = rig with { Cameras = [.. rig.Cameras.Select(camera => camera with { Lens = lens })] },
            Image = rig.Cameras[0].Image,
            QueueCapacity = Math.Max(options.QueueCapacity, 2 * rig.Cameras.Count),
        };
    }

    /// <summary>Why options for a rig, for pairs or for maps cannot be used, as a message for the player; null if they can.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="options"/> is null.</exception>
    public static string? ProblemOf(HarvestOptions options)
    {
        _ = options ?? throw new ArgumentNullException(nameof(options));
        return options.Rig is { } rig ? ProblemOf(options, rig)
            : options.Pairs.IsAny && !options.Freeze
                ? "PairWeathers, PairHours and PairWithout need Mode = Freeze, because all pictures of a pair show one moment."
            : options is { Freeze: false }
            && FrameChannels.All.FirstOrDefault(channel => channel.Folders.Count > 0 && options.Channels.Contains(channel.Key)) is { } map
                ? $"{map.Switch?.Name} needs Mode = Freeze, because its rays are cast while the world stands still."
            : null;
    }

    /// <summary>An estimate of the seconds that one moment of a rig takes in the game, at 60 ticks per second.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="options"/> is null, or has no rig.</exception>
    public static double SecondsPerMoment(HarvestOptions options)
    {
        Rig rig = options?.Rig ?? throw new ArgumentNullException(nameof(options));
        double ticks =
            (rig.Cameras.Count * (double)(options.MaxPictureLagTicks + TicksOfView))
            + (RigBudget.RaysPerMoment(rig, options.Masks, options.Depth) / RaysPerTick);
        return ticks / TicksPerSecond;
    }

    /// <summary>The first sensor of a rig that is inside the body of its vehicle, as a message for the player; null if none is.</summary>
    /// <param name="rig">The rig.</param>
    /// <param name="ego">The vehicle.</param>
    /// <param name="rays">Rays, which meet the vehicle.</param>
    /// <exception cref="ArgumentNullException"><paramref name="rig"/> is null.</exception>
    public static string? BodyProblem(Rig rig, EgoState ego, IRayCaster rays)
    {
        _ = rig ?? throw new ArgumentNullException(nameof(rig));
        return rig
            .Cameras.Select(camera => (camera.Name, camera.Mount))
            .Concat(rig.Lidars.Select(lidar => (lidar.Name, lidar.Mount)))
            .Concat(rig.Radars.Select(radar => (radar.Name, radar.Mount)))
            .Where(sensor => VehicleBody.Encloses(ego, rig.OnVehicle(sensor.Mount).Position, rays))
            .Select(sensor => $"'{sensor.Name}' of the rig '{rig.Name}' is inside the body of the vehicle. Move it outside.")
            .FirstOrDefault();
    }

    /// <summary>What of a rig the game cannot show, one sentence each.</summary>
    /// <param name="rig">The rig as it was read.</param>
    /// <exception cref="ArgumentNullException"><paramref name="rig"/> is null.</exception>
    public static IEnumerable<string> LensWarnings(Rig rig) =>
        (rig ?? throw new ArgumentNullException(nameof(rig)))
            .Cameras.Where(camera => camera.Lens != Lens.Ideal)
            .Take(1)
            .Select(camera =>
                $"The camera '{camera.Name}' of the rig '{rig.Name}' has a lens, which the game cannot imitate. That of [Lens] applies."
            );

    /// <summary>A sentence about the first camera whose shape is not that of the window; null if all have it.</summary>
    /// <param name="rig">The rig.</param>
    /// <param name="windowAspect">Width / height of the window.</param>
    /// <exception cref="ArgumentNullException"><paramref name="rig"/> is null.</exception>
    public static string? AspectWarning(Rig rig, double windowAspect)
    {
        RigCamera? other = (rig ?? throw new ArgumentNullException(nameof(rig))).Cameras.FirstOrDefault(camera =>
            Math.Abs((camera.Image.Aspect / windowAspect) - 1) > AspectTolerance
        );
        return other is null
            ? null
            : FormattableString.Invariant($"The game's window is {windowAspect:0.###} times as wide as high, but the images of ")
                + FormattableString.Invariant($"'{other.Name}' are {other.Image.Width} x {other.Image.Height}: ")
                + "they are stretched, and their horizontal field of view is the window's. Labels account for that.";
    }

    private static string? ProblemOf(HarvestOptions options, Rig rig) =>
        !options.Freeze ? "Rig needs Mode = Freeze, because its camera goes from place to place while the world stands still."
        : options.MaskMethod != MaskMethod.Rays ? "Rig needs Masks = Rays or Off."
        : options.Pairs.IsAny ? "Rig cannot be used together with PairWeathers, PairHours and PairWithout."
        : rig.Cameras.FirstOrDefault(camera => camera.VerticalFovDegrees > MaxFovDegrees) is { } wide
            ? FormattableString.Invariant(
                $"The camera '{wide.Name}' of the rig needs a verticalFovDegrees of at most {MaxFovDegrees}, the widest of the game."
            )
        : RigBudget.ProblemOf(rig, SecondsPerMoment(options));
}
