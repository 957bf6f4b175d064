namespace Harvester.Geometry.Roads;

/// <summary>A piece of road between two nodes; each piece is held once, whichever way it is driven.</summary>
/// <param name="From">Index of the node where it starts.</param>
/// <param name="To">Index of the node where it ends.</param>
/// <param name="LanesForward">Lanes driven from start to end; 0 for a one-way road the other way.</param>
/// <param name="LanesBackward">Lanes driven from end to start; 0 for a one-way road.</param>
/// <param name="MedianWidth">Width of the reservation between the directions, metres; null where the source does not say.</param>
/// <param name="Flags">What the path data says of it.</param>
public sealed record RoadLink(int From, int To, int LanesForward, int LanesBackward, double? MedianWidth, RoadLinkFlags Flags)
{
    /// <summary>Whether it is driven one way only.</summary>
    public bool IsOneWay => LanesForward == 0 || LanesBackward == 0;

    /// <summary>The same piece of road looked at from its other end.</summary>
    public RoadLink Reversed() => new(To, From, LanesBackward, LanesForward, MedianWidth, Flags);
}
