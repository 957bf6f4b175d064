namespace Harvester.Geometry.Paint;

/// <summary>A painted area of the road.</summary>
/// <param name="Kind">What it means.</param>
/// <param name="Corners">The corners of its outline on the ground, at least three, metres, world; counter-clockwise seen from above. That
/// of a crossing surrounds all its bars.</param>
public sealed record PaintedMark(MarkKind Kind, IReadOnlyList<Vector3D> Corners)
{
    /// <summary>Whether a corner lies within a distance of a place.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="range">Metres.</param>
    public bool IsNear(Vector3D place, double range) => Corners.Any(corner => (corner - place).Length <= range);
}
