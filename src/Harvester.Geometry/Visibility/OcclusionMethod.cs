namespace Harvester.Geometry.Visibility;

/// <summary>How the hidden share of an object was determined.</summary>
public enum OcclusionMethod
{
    /// <summary>Not determined.</summary>
    None,

    /// <summary>Rays through the silhouette, counted where they meet the object itself.</summary>
    Rays,

    /// <summary>Rays through the silhouette, all of which met something else before the object's cuboid: it is hidden altogether.</summary>
    CuboidRays,

    /// <summary>The pixel map's visible pixels, and rays that start at the cuboid for the hidden ones.</summary>
    PixelMap,

    /// <summary>An instance map of another tool: the share of the silhouette in which a nearer object is seen.</summary>
    Imported,
}
