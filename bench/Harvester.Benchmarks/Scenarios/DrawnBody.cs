using Harvester.Geometry;

namespace Harvester.Benchmarks.Scenarios;

/// <summary>A body on the ground at one moment.</summary>
/// <param name="Id">The actor's id; null for the ego.</param>
/// <param name="Seconds">Since the beginning.</param>
/// <param name="Middle">Metres, world.</param>
/// <param name="Corners">The corners of its outline, metres, world.</param>
internal sealed record DrawnBody(string? Id, double Seconds, Vector2D Middle, IReadOnlyList<Vector2D> Corners);
