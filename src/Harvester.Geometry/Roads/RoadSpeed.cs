namespace Harvester.Geometry.Roads;

/// <summary>The speed of traffic at a node, as the path data classifies it.</summary>
public enum RoadSpeed
{
    /// <summary>The lowest class.</summary>
    Slow,

    /// <summary>An ordinary street.</summary>
    Normal,

    /// <summary>A main road.</summary>
    Fast,

    /// <summary>A motorway.</summary>
    Faster,
}
