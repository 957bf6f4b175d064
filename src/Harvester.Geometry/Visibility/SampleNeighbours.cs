namespace Harvester.Geometry.Visibility;

/// <summary>
/// Infers what a sample of a silhouette would find from the samples around it that were cast. The outline of what hides an object is where
/// neighbours disagree; elsewhere their answer is that of the sample.
/// </summary>
/// <param name="box">The box around the silhouette; distances between samples are measured in its width and height.</param>
internal sealed class SampleNeighbours(Box2D box)
{
    /// <summary>Hits on the world are on one surface if the farthest is at most this fraction farther than the nearest.</summary>
    private const double SameSurface = 0.1;

    /// <summary>
    /// Neighbours farther away than this answer nothing, in widths and heights of the box: with 0.25, an estimate casts a tenth more rays.
    /// </summary>
    private const double Reach = 0.4;

    /// <summary>The same for neighbours that show one thing without gaps.</summary>
    private const double ReachOfOneThing = 0.5;

    /// <summary>The same for neighbours that show where the object is behind what hides it; they must also surround the sample.</summary>
    private const double ReachOfShape = 0.25;

    private readonly NearestSamples<(SampleFinding Finding, double Distance, SurfacePoint Point)> _cast = new(box);
    private readonly NearestSamples<bool> _shape = new(box);

    /// <summary>Adds a sample that was cast.</summary>
    public void Add(Vector2D pixel, SampleFinding finding, Ray ray, RayHit? hit)
    {
        _cast.Add(pixel, (finding, hit?.Distance ?? 0, hit is { } met ? SurfacePoint.Of(ray, met) : default));
        if (finding != SampleFinding.Stopped)
        {
            AddShape(pixel, finding != SampleFinding.Gap);
        }
    }

    /// <summary>Adds whether the object is at a sample, hidden or not.</summary>
    public void AddShape(Vector2D pixel, bool isObject) => _shape.Add(pixel, isObject);

    /// <summary>What a sample would find; null if the nearest samples do not agree.</summary>
    public SampleFinding? Infer(Vector2D pixel) =>
        _cast.Near(pixel, Reach) is not { } near ? null
        : near.All(static sample => sample.Finding is SampleFinding.OnObject or SampleFinding.Gap) ? near[0].Finding
        : AreStopped(near) && AreEquallyFar(near) ? SampleFinding.Stopped
        : null;

    /// <summary>
    /// Whether something is in front of an object of which no sample has seen anything yet. A gap between things at similar distances may
    /// show it, so they must be one thing without gaps.
    /// </summary>
    public bool IsBehindOneThing(Vector2D pixel) =>
        _cast.Near(pixel, ReachOfOneThing) is { } near
        && AreStopped(near)
        && SurfacePoint.AreOnOneThing([.. near.Select(static sample => sample.Point)]);

    /// <summary>Whether the object is at a sample in front of which something lies; null if the nearest samples do not agree.</summary>
    public bool? InferShape(Vector2D pixel) =>
        _shape.Near(pixel, ReachOfShape) is { } near && near.All(isObject => isObject == near[0]) && _shape.Surround(pixel)
            ? near[0]
            : null;

    private static bool AreStopped(IReadOnlyList<(SampleFinding Finding, double Distance, SurfacePoint Point)> near) =>
        near.All(static sample => sample.Finding == SampleFinding.Stopped);

    private static bool AreEquallyFar(IReadOnlyList<(SampleFinding Finding, double Distance, SurfacePoint Point)> near)
    {
        int thing = near[0].Point.Entity;
        return near.All(sample => sample.Point.Entity == thing)
            && (
                thing != RayHit.World
                || near.Max(static sample => sample.Distance) <= near.Min(static sample => sample.Distance) * (1 + SameSurface)
            );
    }
}
