namespace Harvester.Geometry.Lanes;

/// <summary>An unbroken run of a lane boundary or a painted marking within an image.</summary>
/// <param name="Index">Number of the boundary; see <see cref="LaneLine.Index"/>.</param>
/// <param name="IsLeftOfCar">Whether it lies to the left of the car.</param>
/// <param name="Points">At least two points, nearest first; the ends lie on the image's border if the line leaves it.</param>
public sealed record LaneLineView(int Index, bool IsLeftOfCar, IReadOnlyList<LaneLinePoint> Points)
{
    /// <summary>How it is painted; null for a boundary of lanes.</summary>
    public MarkingPaint? Paint { get; init; }

    /// <summary>Standard deviation of measured paint across the road, metres; null for other lines.</summary>
    public double? SigmaMetres { get; init; }
}
