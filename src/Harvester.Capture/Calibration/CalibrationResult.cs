using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;

namespace Harvester.Capture.Calibration;

/// <summary>What a calibration found.</summary>
/// <param name="Lens">The lens, for the options of a harvest.</param>
/// <param name="Before">The error of a camera without a lens over the markers that were used, pixels.</param>
/// <param name="After">The error that is left.</param>
/// <param name="CornerUncertaintyPixels">Standard deviation of the model in the image's worst corner, pixels.</param>
/// <param name="Shown">Markers shown.</param>
/// <param name="Outliers">Markers seen that were left out because they disagree.</param>
public sealed record CalibrationResult(
    Lens Lens, ReprojectionError Before, ReprojectionError After, double CornerUncertaintyPixels, int Shown, int Outliers);
