using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Validation;

/// <summary>Checks the camera of a frame: its values are valid, and its focal lengths agree with the others.</summary>
internal static class CameraCheck
{
    /// <summary>
    /// Tolerance of the focal lengths, far above the effect of rounding the field of view and the aspect ratio to nine decimals.
    /// </summary>
    private const double RoundingPixels = 0.001;

    public static IEnumerable<string> Problems(CameraLabel label)
    {
        CameraIntrinsics made;
        try
        {
            made = LabelCamera.Of(label).Intrinsics;
        }
        catch (DatasetFormatException e)
        {
            return [e.Message];
        }

        return Math.Abs(label.Fx - made.Fx) > RoundingPixels || Math.Abs(label.Fy - made.Fy) > RoundingPixels
            ?
            [
                FormattableString.Invariant(
                    $"camera: fx and fy are {label.Fx} and {label.Fy}, but the other fields give {made.Fx:0.######} and {made.Fy:0.######}."
                ),
            ]
            : [];
    }
}
