using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;

namespace Harvester.Capture.Calibration;

/// <summary>The result of a calibration.</summary>
/// <param name="Lens">The lens, for the options of a harvest.</param>
/// <param name="Before">The error of an ideal pinhole camera over the markers used, pixels.</param>
/// <param name="After">The error of the fitted lens over the same markers.</param>
/// <param name="Validation">The error over markers that the lens was not fitted to.</param>
/// <param name="UncertaintyPixels">Upper bound of the lens's error anywhere in the image, in at least 95 of 100 calibrations,
/// pixels.</param>
/// <param name="Shown">Number of markers shown for the fit.</param>
/// <param name="Outliers">Number of visible markers that were rejected as outliers.</param>
public sealed record CalibrationResult(
    Lens Lens,
    ReprojectionError Before,
    ReprojectionError After,
    ReprojectionError Validation,
    double UncertaintyPixels,
    int Shown,
    int Outliers
);
