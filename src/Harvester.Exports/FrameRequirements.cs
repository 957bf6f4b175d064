using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports;

/// <summary>Requirements of a format for every frame.</summary>
internal static class FrameRequirements
{
    /// <exception cref="DatasetFormatException">The frame lacks something that the format requires, or has something that it cannot
    /// represent.</exception>
    public static void Check(DatasetFormat format, ExportOptions options, ExportFrame frame)
    {
        if (format.NeedsMasks && frame.Label.Mask is null)
        {
            throw frame.Problem($"it has no mask, which {format.Name} needs. Harvest with masks, or choose another format.");
        }

        if (format.NeedsClassMaps && frame.Label.ClassMap is null)
        {
            throw frame.Problem($"it has no class map, which {format.Name} needs. Harvest with --semantics, or choose another format.");
        }

        if (format.NeedsLanes && frame.Label.Lanes is null)
        {
            throw frame.Problem($"it has no lanes, which {format.Name} needs. Harvest with roads, or choose another format.");
        }

        if (format.NeedsImu && frame.IsFirstView && frame.Label.Channels.Get<ImuLabel>() is null)
        {
            throw frame.Problem($"it has no samples of an inertial unit, which {format.Name} needs. Harvest with --imu.");
        }

        if (format.NeedsOccupancy && frame.Label.Channels.Get<OccupancyLabel>() is null)
        {
            throw frame.Problem($"it has no voxels, which {format.Name} needs. Harvest with --occupancy.");
        }

        if (format.HasMap && options.Roads is null && !frame.HasFile(FramePaths.Roads))
        {
            throw frame.Problem(
                $"its session has no {FramePaths.Roads}, from which {format.Name} takes the lanes. Name the roads with --roads, or choose "
                    + "another format."
            );
        }

        if (format.KeepsSequences && IntrinsicsOf(frame.Label.Camera) != IntrinsicsOf(frame.SequenceCamera))
        {
            throw frame.Problem(
                "its camera calibration differs from that of the first frame at its place, "
                    + $"and {format.Name} has one per sequence. Choose another format."
            );
        }

        if (frame.RateHz > 0 && frame.RateHz < format.MinRateHz)
        {
            throw frame.Problem(
                FormattableString.Invariant($"its session has {frame.RateHz:0.###} moments a second, and {format.Name} ")
                    + FormattableString.Invariant($"needs {format.MinRateHz:0.##} or more, as its readers take velocities from them. ")
                    + "Harvest with a higher --hz, or choose another format."
            );
        }

        if (format.NeedsRectilinear && LensDistortion.PixelsOf(frame.Label.Camera) is var bend and > LensDistortion.MaxPixels)
        {
            throw frame.Problem(
                FormattableString.Invariant($"its lens bends straight lines by {bend:0.0} pixels, ")
                    + $"and {format.Name} cannot represent lens distortion. Choose another format."
            );
        }
    }

    private static (double Fx, double Fy, double Cx, double Cy) IntrinsicsOf(CameraLabel camera) =>
        (camera.Fx, camera.Fy, camera.Cx, camera.Cy);
}
