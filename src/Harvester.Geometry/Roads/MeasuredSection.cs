namespace Harvester.Geometry.Roads;

/// <summary>
/// The lanes of one direction of a link at a station, as lines painted on it show them. An edge is the middle of its line.
/// </summary>
/// <param name="LeftEdge">Offset of the left edge of the leftmost lane, metres to the right of the link's line in that direction.</param>
/// <param name="Section">The lanes.</param>
/// <param name="IsWhole">Whether lines show both outer edges, some of them on this link; otherwise lanes are taken from the road next to
/// it, or edges from the width of other lanes.</param>
public readonly record struct MeasuredSection(double LeftEdge, LaneSection Section, bool IsWhole);
