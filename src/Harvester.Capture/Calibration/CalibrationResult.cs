using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;

namespace Harvester.Capture.Calibration;

/// <summary>What a calibration found.</summary>
/// <param name="Lens">The lens, for the options of a harvest.</param>
/// <param name="Before">The error of a camera without a lens over the markers that were used, pixels.</param>
/// <param name="After">The error that is left.</param>
/// <param name="Validation">The error over markers that the lens was not fitted to.</param>
/// <param name="UncertaintyPixels">What the lens is off by at most anywhere in the image, in at least 95 of 100 calibrations,
/// pixels.</param>
/// <param name="Shown">Markers shown for the fit.</param>
/// <param name="Outliers">Markers seen that were left out because they disagree.</param>
public sealed record CalibrationResult(
    Lens Lens, ReprojectionError Before, ReprojectionError After, ReprojectionError Validation, double UncertaintyPixels, int Shown,
        int Outliers);
