using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;

namespace Harvester.Capture.Calibration;

/// <summary>Validates a fitted lens by markers that it was not fitted to, and names the likely cause if it is rejected.</summary>
internal static class CalibrationJudge
{
    // A partly hidden marker appears off by less than its radius. As in the fit, most markers must be completely visible.
    private const double MinAgreeing = 0.5;

    // A spot farther off belongs to another marker, or is a chance change of the image.
    private const double MaxTeleported = 0.1;

    // As in the fit: noise does not exceed this.
    private const double NoiseBound = 6;

    // Markers cannot be located better than this, pixels.
    private const double MinNoise = 0.02;

    /// <summary>The error over those markers, without the few that are partly hidden.</summary>
    /// <param name="fit">The fit, with a result.</param>
    /// <param name="camera">The camera with the fitted lens.</param>
    /// <param name="fitted">The sightings that it was fitted to.</param>
    /// <param name="others">Sightings of other markers.</param>
    /// <param name="shown">How many of those markers were shown.</param>
    /// <param name="options">The maximum error, and the size of the markers.</param>
    /// <exception cref="CalibrationException">The lens is rejected.</exception>
    public static ReprojectionError Validate(
        LensFit fit,
        CameraIntrinsics camera,
        IReadOnlyList<Sighting> fitted,
        IReadOnlyList<Sighting> others,
        int shown,
        CalibrationOptions options
    )
    {
        double thresholdPixels = options.ThresholdPixels;
        double worst = Math.Max(fit.Error.RmsPixels, fit.UncertaintyPixels);
        if (worst > thresholdPixels)
        {
            string cause = CauseOf(camera, [.. fitted, .. others]);
            throw new CalibrationException(
                FormattableString.Invariant(
                    $"The lens is uncertain by {worst:0.###} px, more than the {thresholdPixels:0.###} px allowed: {cause}"
                )
            );
        }

        if (2 * others.Count < shown)
        {
            throw new CalibrationException(
                $"The lens cannot be checked: too few other markers are visible, {others.Count} of {shown}. "
                    + "Give the camera a free view or a smaller field of view, and calibrate again."
            );
        }

        double noise = Math.Max(MinNoise, fit.Error.RmsPixels / Math.Sqrt(2));
        Sighting[] agreeing = [.. others.Where(sighting => ErrorOf(camera, sighting) <= NoiseBound * noise + fit.UncertaintyPixels)];
        int elsewhere = others.Count(sighting => ErrorOf(camera, sighting) > options.MarkerRadiusPixels);
        if (agreeing.Length < MinAgreeing * others.Count || elsewhere > MaxTeleported * others.Count)
        {
            int wrong = Math.Max(others.Count - agreeing.Length, elsewhere);
            throw new CalibrationException(
                $"The lens misplaces {wrong} of {others.Count} markers that were not used for the fit, "
                    + $"as if markers were confused with each other: {CauseOf(camera, others)}"
            );
        }

        var error = ReprojectionError.Of(camera, agreeing);
        return error.RmsPixels <= thresholdPixels
            ? error
            : throw new CalibrationException(
                FormattableString.Invariant($"Markers that were not used for the fit are {error.RmsPixels:0.###} px off, ")
                    + FormattableString.Invariant($"more than the {thresholdPixels:0.###} px allowed: ")
                    + CauseOf(camera, others)
            );
    }

    private static double ErrorOf(CameraIntrinsics camera, Sighting sighting) => ReprojectionError.Of(camera, [sighting]).MaxPixels;

    private static string CauseOf(CameraIntrinsics camera, IReadOnlyList<Sighting> sightings) =>
        MisfitFinder.Of(camera, sightings) switch
        {
            Misfit.Stretch =>
                "the picture is stretched along one axis. Check that the game's window has the aspect ratio that the game reports.",
            Misfit.CameraPosition => "the camera is not where the game reports it. Check that no other mod moves it.",
            Misfit.CameraRoll => "the roll of the camera is not as the game reports it. Check that no other mod moves it.",
            Misfit.LensShape => "the distortion cannot be described by k1 and k2. Turn off lens effects of the game or of other mods.",
            _ => "the measured positions of the markers are noisy. Calibrate in clear weather with nothing moving in view, or "
                + "in larger images.",
        };
}
