using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Calibration;

/// <summary>How the camera is calibrated. Every value is checked when it is set.</summary>
/// <exception cref="System.ArgumentOutOfRangeException">A value is out of its range.</exception>
public sealed record CalibrationOptions
{
    /// <summary>Size of the images used for calibration, pixels. The lens itself does not depend on it.</summary>
    public ImageSize Image { get; init; } = new(800, 600);

    /// <summary>
    /// Maximum error of the camera model, pixels, greater than 0: over the markers, and as uncertainty in the image's corners.
    /// </summary>
    public double ThresholdPixels
    {
        get;
        init => field = OptionCheck.Positive(value, nameof(ThresholdPixels));
    } = 1;

    /// <summary>
    /// Maximum number of ticks by which the picture may lag behind the state, 0 to 60; the calibration waits that long before each image.
    /// </summary>
    public int MaxPictureLagTicks
    {
        get;
        init => field = OptionCheck.InRange(value, 0, PictureLag.MaxTicks, nameof(MaxPictureLagTicks));
    } = 4;

    /// <summary>Maximum number of ticks until the camera stands still, 1 to 10,000; after that the calibration fails.</summary>
    public int MaxSettleTicks
    {
        get;
        init => field = OptionCheck.InRange(value, 1, 10_000, nameof(MaxSettleTicks));
    } = 300;

    /// <summary>
    /// Radius of a marker in the image, pixels, greater than 0; larger markers are located more accurately and hidden more often.
    /// </summary>
    public double MarkerRadiusPixels
    {
        get;
        init => field = OptionCheck.Positive(value, nameof(MarkerRadiusPixels));
    } = 6;

    /// <summary>Depths of the markers, metres. Near ones are rarely hidden, and lie above the ground.</summary>
    public IReadOnlyList<double> MarkerDepths { get; init; } = [0.9, 1.2, 1.6];
}
