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
    /// <summary>The lanes across it at its start, and where they change evenly between, up to its end; at least one section. Behind the
    /// last one the lanes are as there.</summary>
    public IReadOnlyList<RoadSection> Sections { get; internal init; } = [];
}
