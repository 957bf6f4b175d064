namespace Harvester.Geometry.Visibility;

/// <summary>How a figure of occlusion was come by.</summary>
public enum OcclusionMethod
{
    /// <summary>Not determined.</summary>
    None,

    /// <summary>Rays through the silhouette, counted where they meet the object itself.</summary>
    Rays,

    /// <summary>Rays to the cuboid: none of them met the object itself, so all of its silhouette counts.</summary>
    CuboidRays,

    /// <summary>The pixel map's visible pixels, and rays that start at the cuboid for the hidden ones.</summary>
    PixelMap,

    /// <summary>The cuboid's silhouette less what lies nearer, because rays do not meet the object.</summary>
    Silhouettes,

    /// <summary>An instance map of another tool: the share of the silhouette in which a nearer object is seen.</summary>
    Imported,
}
