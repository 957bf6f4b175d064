using Harvester.Sessions.Labels;

namespace Harvester.Reports.Viewing;

/// <summary>Finds the files of a frame.</summary>
internal static class FrameRasters
{
    /// <summary>Path of the file within the session, with forward slashes; null if the frame has none.</summary>
    public static string? FileOf(this FrameRaster raster, FrameLabel label) =>
        raster switch
        {
            FrameRaster.Mask => label.Mask,
            FrameRaster.Depth => label.Depth is { } depth ? depth.Completed ?? depth.Sparse : null,
            _ => label.Image,
        };
}
