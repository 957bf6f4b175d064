using System.Collections.Generic;

namespace Harvester.Geometry.Lanes;

/// <summary>A line along a road in the world: a boundary of lanes, or a painted marking.</summary>
/// <param name="Index">
/// Number of the lane boundary. Of the car's direction: 0 is the left edge of its leftmost lane, n the right edge of its n-th. Of the
/// other direction: -1 is the edge of its lanes at the median, -2 the next to the left of the car, and so on; where there is no median,
/// -1 would lie on 0 and is left out. A painted marking has the number of the boundary that it marks.
/// </param>
/// <param name="IsLeftOfCar">Whether it lies to the left of the car.</param>
/// <param name="Points">Points along it, nearest first.</param>
public sealed record LaneLine(int Index, bool IsLeftOfCar, IReadOnlyList<LinePoint> Points)
{
    /// <summary>What it is painted like; null for a boundary of lanes.</summary>
    public MarkingPaint? Paint { get; init; }
}
