using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>The part of a link outside junctions.</summary>
/// <param name="Id">A name that depends on the link's nodes alone.</param>
/// <param name="Link">Index of the link.</param>
/// <param name="Line">The link's line there, from the link's start to its end.</param>
/// <param name="Forward">The lanes from start to end, from left to right; empty for a one-way road the other way.</param>
/// <param name="Backward">The lanes from end to start, from left to right in that direction.</param>
/// <param name="Start">What it meets at its start.</param>
/// <param name="End">What it meets at its end.</param>
public sealed record RoadSegment(
    string Id,
    int Link,
    HermiteCurve Line,
    IReadOnlyList<MapLane> Forward,
    IReadOnlyList<MapLane> Backward,
    SegmentEnd Start,
    SegmentEnd End
)
{
    /// <summary>Offset of the left edge of the leftmost forward lane, metres to the right of the line.</summary>
    public double ForwardLeftEdge { get; internal init; }

    /// <summary>
    /// Offset of the left edge of the leftmost backward lane, metres to the right of the line as seen from its end to its start.
    /// </summary>
    public double BackwardLeftEdge { get; internal init; }
}
