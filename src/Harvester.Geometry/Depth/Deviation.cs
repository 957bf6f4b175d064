namespace Harvester.Geometry.Depth;

/// <summary>How well the surface that one ray met predicts what another one of the same region met.</summary>
internal static class Deviation
{
    /// <summary>The deviation as a fraction of the depth, 0 to 1; 0 for samples of different regions, which say nothing about each other.
    /// </summary>
    /// <param name="from">The sample whose plane is extended.</param>
    /// <param name="sample">The sample that is predicted.</param>
    /// <param name="line">Its line of sight.</param>
    // |depth / predicted depth - 1|; a hit and a miss, or two entities, predict nothing of each other and deviate wholly.
    public static double Of(DepthSample from, DepthSample sample, SightLine line) =>
        from.Region != sample.Region ? 0
        : from.IsHit != sample.IsHit || from.Entity != sample.Entity ? 1
        : !sample.IsHit ? 0
        : Math.Min(1, Math.Abs((from.Surface.InverseAt(line) * sample.Depth) - 1));
}
