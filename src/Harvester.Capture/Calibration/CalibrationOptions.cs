using System.Collections.Generic;
using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Calibration;

/// <summary>How the camera is calibrated. Every value is checked where it is set.</summary>
/// <exception cref="System.ArgumentOutOfRangeException">A value is out of its range.</exception>
public sealed record CalibrationOptions
{
    /// <summary>Size of the pictures to calibrate for, pixels. The lens itself does not depend on it.</summary>
    public ImageSize Image { get; init; } = new(800, 600);

    /// <summary>
    /// The largest error that a camera model may have, pixels, greater than 0: over the markers, and as uncertainty in the image's corners.
    /// </summary>
    public double ThresholdPixels { get; init => field = OptionCheck.Positive(value, nameof(ThresholdPixels)); } = 1;

    /// <summary>By how many ticks the picture may at most be behind the state, 0 to 60; as long is waited before each picture.</summary>
    public int MaxPictureLagTicks
    {
        get;
        init => field = OptionCheck.InRange(value, 0, PictureLag.MaxTicks, nameof(MaxPictureLagTicks));
    } = 4;

    /// <summary>Ticks in which the camera must have come to stand still, 1 to 10,000; otherwise the calibration fails.</summary>
    public int MaxSettleTicks { get; init => field = OptionCheck.InRange(value, 1, 10_000, nameof(MaxSettleTicks)); } = 300;

    /// <summary>How large a marker looks, pixels, greater than 0; larger ones are found more exactly and hidden more often.</summary>
    public double MarkerRadiusPixels { get; init => field = OptionCheck.Positive(value, nameof(MarkerRadiusPixels)); } = 6;

    /// <summary>Depths of the markers, metres. Near ones are hidden by nothing, and lie above the ground.</summary>
    public IReadOnlyList<double> MarkerDepths { get; init; } = [0.9, 1.2, 1.6];
}
