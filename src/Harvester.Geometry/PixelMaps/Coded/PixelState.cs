namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>What a pixel in the silhouette of an object shows.</summary>
internal enum PixelState : byte
{
    /// <summary>Something else, which does not change with the object.</summary>
    Other,

    /// <summary>The object.</summary>
    Object,

    /// <summary>Something else in the shadow of the object, or with its reflection.</summary>
    Shadow,

    /// <summary>A pixel at the edge, of which the object covers less than half.</summary>
    Edge,
}
