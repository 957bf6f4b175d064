namespace Harvester.Geometry.PixelMaps;

/// <summary>How an object's pixels were come by.</summary>
public enum PixelMapMethod
{
    /// <summary>By rays, and between them by straight outlines.</summary>
    Rays,

    /// <summary>From its cuboid's silhouette less what lies nearer, because rays do not meet it.</summary>
    Silhouette,
}
