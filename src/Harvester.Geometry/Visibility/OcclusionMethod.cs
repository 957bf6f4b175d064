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
}
