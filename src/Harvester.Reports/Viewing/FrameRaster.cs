namespace Harvester.Reports.Viewing;

/// <summary>A file of a frame that has its pixels.</summary>
public enum FrameRaster
{
    /// <summary>The image.</summary>
    Image,

    /// <summary>The instance mask: ids of objects.</summary>
    Mask,

    /// <summary>The depth map, completed if there is one: 1/256 m.</summary>
    Depth,
}
