using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Calibration;

/// <summary>A lens fitted to sightings, and how well it fits them.</summary>
/// <param name="Outcome">Whether there is a result; without one the lens is ideal and every number is 0.</param>
/// <param name="Lens">The lens.</param>
/// <param name="Error">The reprojection error of the lens over the sightings used.</param>
/// <param name="ErrorWithout">The reprojection error of an ideal pinhole camera over the same sightings.</param>
/// <param name="OutlierCount">Sightings rejected because they disagree with the others.</param>
/// <param name="CornerUncertaintyPixels">
/// Standard deviation of the position that the lens gives for the worst corner of the image, pixels, caused by the noise of the sightings.
/// It is large if the sightings do not reach towards the corners.
/// </param>
public readonly record struct LensFit(
    LensFitOutcome Outcome,
    Lens Lens,
    ReprojectionError Error,
    ReprojectionError ErrorWithout,
    int OutlierCount,
    double CornerUncertaintyPixels
)
{
    // Of errors that are normal along both axes, a fraction exp(-3² / 2) = 1.1 % exceeds three standard deviations: at most 4.4 % at any of
    // four corners.
    private const double Deviations = 3;

    /// <summary>Upper bound of the lens's error anywhere in the image, pixels, which holds in at least 95 of 100 fits.</summary>
    public double UncertaintyPixels => Deviations * CornerUncertaintyPixels;
}
