namespace Harvester.Geometry.Roads;

/// <summary>A piece of road between two nodes; each piece is stored once, whatever its directions of travel.</summary>
/// <param name="From">Index of the node where it starts.</param>
/// <param name="To">Index of the node where it ends.</param>
/// <param name="LanesForward">Lanes driven from start to end; 0 for a one-way road the other way.</param>
/// <param name="LanesBackward">Lanes driven from end to start; 0 for a one-way road.</param>
/// <param name="MedianWidth">Width of the median between the directions, metres; null if the source does not give it.</param>
/// <param name="Flags">The flags of the path data.</param>
public sealed record RoadLink(int From, int To, int LanesForward, int LanesBackward, double? MedianWidth, RoadLinkFlags Flags)
{
    /// <summary>Whether it has lanes in one direction only.</summary>
    public bool IsOneWay => LanesForward == 0 || LanesBackward == 0;

    /// <summary>The same piece of road seen from its other end.</summary>
    public RoadLink Reversed() => new(To, From, LanesBackward, LanesForward, MedianWidth, Flags);
}
