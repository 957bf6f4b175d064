namespace Harvester.Geometry.Roads;

/// <summary>The lanes of one direction of a link, as lines painted on it show them.</summary>
/// <param name="LeftEdge">Offset of the left edge of the leftmost lane, metres to the right of the link's line in that direction.</param>
/// <param name="LaneWidth">Mean width of its lanes, metres; greater than 0.</param>
public readonly record struct MeasuredSection(double LeftEdge, double LaneWidth);
