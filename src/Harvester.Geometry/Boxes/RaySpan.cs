namespace Harvester.Geometry.Boxes;

/// <summary>The part of a ray that lies within a solid.</summary>
/// <param name="Entry">Distance of entry, metres; 0 if the ray starts inside.</param>
/// <param name="Exit">Distance of exit, metres; at least <paramref name="Entry"/>.</param>
public readonly record struct RaySpan(double Entry, double Exit);
