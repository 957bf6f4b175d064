namespace Harvester.Geometry.Paint;

/// <summary>
/// A stop line or crossing in one image. Distances and offsets are those of its <see cref="JunctionMouth"/>, metres.
/// </summary>
/// <param name="Image">Number of the image.</param>
/// <param name="Kind">What it is.</param>
/// <param name="From">Distance of its near edge, in the middle between its ends.</param>
/// <param name="To">Distance of its far edge there.</param>
/// <param name="Left">Offset of its left end.</param>
/// <param name="Right">Offset of its right end.</param>
/// <param name="Slope">Growth of the distances with the offset; 0 for a crossing.</param>
/// <param name="Sigma">Standard deviation of the distances.</param>
internal readonly record struct SeenMark(
    int Image,
    MarkKind Kind,
    double From,
    double To,
    double Left,
    double Right,
    double Slope,
    double Sigma
)
{
    /// <summary>Whether the ground beyond the left end was seen.</summary>
    public bool IsLeftFree { get; init; }

    /// <summary>Whether the ground beyond the right end was seen.</summary>
    public bool IsRightFree { get; init; }

    /// <summary>Whether the ground before the near edge was seen.</summary>
    public bool IsNearFree { get; init; }

    /// <summary>Whether the ground behind the far edge was seen.</summary>
    public bool IsFarFree { get; init; }

    public double Middle => (From + To) / 2;
}
