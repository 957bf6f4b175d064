namespace Harvester.Geometry.Lanes;

/// <summary>A line along a road in the world: a boundary of lanes, or a painted marking.</summary>
/// <param name="Index">
/// Number of the lane boundary. In the car's direction, 0 is the left edge of the leftmost lane and n the right edge of the n-th lane. In
/// the other direction, -1 is the edge of the lanes at the median, -2 the next to the left of the car, and so on; without a median, -1
/// would coincide with 0 and is left out. A painted marking has the number of the boundary that it marks.
/// </param>
/// <param name="IsLeftOfCar">Whether it lies to the left of the car.</param>
/// <param name="Points">Points along it, nearest first.</param>
public sealed record LaneLine(int Index, bool IsLeftOfCar, IReadOnlyList<LinePoint> Points)
{
    /// <summary>How it is painted; null for a boundary of lanes.</summary>
    public MarkingPaint? Paint { get; init; }

    /// <summary>Standard deviation of measured paint across the road, metres; null for other lines.</summary>
    public double? SigmaMetres { get; init; }
}
