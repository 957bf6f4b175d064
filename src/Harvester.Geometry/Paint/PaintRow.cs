namespace Harvester.Geometry.Paint;

/// <summary>What one or more images show of a strip across a link, <see cref="Length"/> metres long.</summary>
public sealed class PaintRow
{
    /// <summary>Length of a row along the link, metres: shorter than the shortest dash and the shortest gap.</summary>
    public const double Length = 0.5;

    /// <summary>The stripes.</summary>
    public List<PaintCandidate> Candidates { get; } = [];

    /// <summary>The parts that were seen.</summary>
    public List<SeenSpan> Seen { get; } = [];

    /// <summary>Number of images that were added.</summary>
    internal int Images { get; set; }
}
