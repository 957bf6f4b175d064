namespace Harvester.Geometry.Visibility;

/// <summary>How the hidden fraction of an object was determined.</summary>
public enum OcclusionMethod
{
    /// <summary>Not determined.</summary>
    None,

    /// <summary>Rays through the silhouette, counted if they hit the object itself.</summary>
    Rays,

    /// <summary>Rays through the silhouette, all of which hit something in front of the object's cuboid: it is completely hidden.</summary>
    CuboidRays,

    /// <summary>The visible pixels of the pixel map, and rays that start at the cuboid for the hidden ones.</summary>
    PixelMap,

    /// <summary>An instance map of another tool: the fraction of the silhouette in which a nearer object is seen.</summary>
    Imported,
}
