namespace Harvester.Geometry.Roads;

/// <summary>How fast traffic drives at a node, as the path data grades it.</summary>
public enum RoadSpeed
{
    /// <summary>The least of the grades.</summary>
    Slow,

    /// <summary>An ordinary street.</summary>
    Normal,

    /// <summary>A main road.</summary>
    Fast,

    /// <summary>A motorway.</summary>
    Faster,
}
