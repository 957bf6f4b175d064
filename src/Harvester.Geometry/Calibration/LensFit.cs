using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Calibration;

/// <summary>A lens fitted to sightings, and how well it explains them.</summary>
/// <param name="Outcome">Whether there is a result; without one the lens is ideal and every number 0.</param>
/// <param name="Lens">The lens.</param>
/// <param name="Error">What is left between the sightings that were used and where the lens puts them.</param>
/// <param name="ErrorWithout">What a pinhole would leave of the same sightings.</param>
/// <param name="OutlierCount">Sightings that were left out because they disagree with all others.</param>
/// <param name="CornerUncertaintyPixels">
/// Standard deviation of the position that the lens gives for the worst corner of the image, pixels: what the noise of the sightings
/// leaves open. It is large where the sightings do not reach toward the corners.
/// </param>
public readonly record struct LensFit(
    LensFitOutcome Outcome, Lens Lens, ReprojectionError Error, ReprojectionError ErrorWithout, int OutlierCount,
        double CornerUncertaintyPixels)
{
    // Of errors that are normal along both axes a part of exp(-3² / 2) = 1.1 % is larger than three standard deviations: at most 4.4 % at
    // any of four corners.
    private const double Deviations = 3;

    /// <summary>What the lens is off by at most, pixels, anywhere in the image, in at least 95 of 100 fits.</summary>
    public double UncertaintyPixels => Deviations * CornerUncertaintyPixels;
}
