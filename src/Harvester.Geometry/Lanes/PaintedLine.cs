namespace Harvester.Geometry.Lanes;

/// <summary>A line painted on the ground, from the start of the paint to its end; the gaps of a dashed line are part of it.</summary>
/// <param name="Paint">How it is painted.</param>
/// <param name="Points">Points along its middle, in either direction; at least two.</param>
public sealed record PaintedLine(MarkingPaint Paint, IReadOnlyList<LinePoint> Points)
{
    /// <summary>Standard deviation of its position across the road, metres, if it was measured; null if it is exact.</summary>
    public double? SigmaMetres { get; init; }
}
