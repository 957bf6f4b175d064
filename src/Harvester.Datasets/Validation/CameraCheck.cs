using System;
using System.Collections.Generic;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sessions;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>What must hold for the camera of a frame: it can be made, and its focal lengths follow from the rest.</summary>
internal static class CameraCheck
{
    /// <summary>The field of view and the aspect are rounded to nine decimals in files, which is far less than this.</summary>
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
            ? [FormattableString.Invariant($"camera: fx and fy are {label.Fx} and {label.Fy}, but the other fields make them {made.Fx:0.######} and {made.Fy:0.######}.")]
            : [];
    }
}
