namespace Harvester.Geometry.Paint;

/// <summary>A painted area that was measured in images.</summary>
/// <param name="Mark">What it means, and its outline.</param>
public sealed record MarkPaint(PaintedMark Mark)
{
    /// <summary>Standard deviation of its position along the road, metres; greater than 0.</summary>
    public required double SigmaMetres { get; init; }

    /// <summary>Number of images that show it; at least 1.</summary>
    public required int Images { get; init; }
}
