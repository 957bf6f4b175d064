namespace Harvester.Geometry.Paint;

/// <summary>A painted area of the road.</summary>
/// <param name="Kind">What it means.</param>
/// <param name="Corners">The corners of its outline on the ground, at least three, metres, world; counter-clockwise seen from above. That
/// of a crossing surrounds all its bars.</param>
public sealed record PaintedMark(MarkKind Kind, IReadOnlyList<Vector3D> Corners);
